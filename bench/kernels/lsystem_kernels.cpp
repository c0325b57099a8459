// From the text of a grammar to what it draws.

#include "lsystem/derive.h"
#include "lsystem/grammar_text.h"
#include "lsystem/interpret.h"
#include "lsystem/to_scene.h"
#include "made_inputs.h"
#include "sizes.h"

namespace rinceau::bench {
namespace {

/// A flat list: as many modules of the axiom as elements, and more.
void grammar_reading(benchmark::State& state) {
    std::string text = "lsystem 1\naxiom:";
    for (int i = 0; i < size_of(state); ++i) text += " [f(" + std::to_string(i) + ") -(30) A]";
    text += "\nterminal A: path \"M0 0L1 0L0 1Z\"\n";
    for (auto _ : state) benchmark::DoNotOptimize(parse_grammar(text));
    set_size(state, static_cast<std::size_t>(size_of(state)));
}
BENCHMARK(grammar_reading)->Apply(to_100000);

void derivation(benchmark::State& state) {
    const Grammar grammar = parse_grammar(ornament_text(size_of(state)));
    std::size_t modules = 0;
    for (auto _ : state) modules = derive(grammar).modules.size();
    set_size(state, modules);
}
BENCHMARK(derivation)->Apply(to_100000);

void interpretation(benchmark::State& state) {
    const Grammar grammar = parse_grammar(ornament_text(size_of(state)));
    std::size_t placements = 0;
    for (auto _ : state) placements = interpret(grammar).size();
    set_size(state, placements);
}
BENCHMARK(interpretation)->Apply(to_100000);

void placements_to_scene(benchmark::State& state) {
    const Grammar grammar = parse_grammar(ornament_text(size_of(state)));
    const std::vector<Placement> placements = interpret(grammar);
    for (auto _ : state) benchmark::DoNotOptimize(to_scene(grammar, placements));
    set_size(state, placements.size());
}
BENCHMARK(placements_to_scene)->Apply(to_100000);

}  // namespace
}  // namespace rinceau::bench
