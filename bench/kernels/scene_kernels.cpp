// Drawings in and out.

#include "made_inputs.h"
#include "scene/svg_path_data.h"
#include "scene/svg_read.h"
#include "scene/svg_write.h"
#include "sizes.h"

namespace rinceau::bench {
namespace {

void svg_reading(benchmark::State& state) {
    const Scene scene = drawn(ornament_text(size_of(state)));
    const std::string text = write_svg(scene);
    for (auto _ : state) benchmark::DoNotOptimize(read_svg(text));
    set_size(state, scene.elements.size());
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(text.size()));
}
BENCHMARK(svg_reading)->Apply(to_100000);

void svg_writing(benchmark::State& state) {
    const Scene scene = drawn(ornament_text(size_of(state)));
    for (auto _ : state) benchmark::DoNotOptimize(write_svg(scene));
    set_size(state, scene.elements.size());
}
BENCHMARK(svg_writing)->Apply(to_100000);

/// One attribute `d` of so many sub-paths.
void path_data_reading(benchmark::State& state) {
    std::string data;
    for (const Element& element : drawn(clutter_text(size_of(state))).elements) data += svg_path_data(element.paths);
    for (auto _ : state) benchmark::DoNotOptimize(parse_path_data(data));
    set_size(state, static_cast<std::size_t>(size_of(state)));
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(data.size()));
}
BENCHMARK(path_data_reading)->Apply(to_100000);

}  // namespace
}  // namespace rinceau::bench
