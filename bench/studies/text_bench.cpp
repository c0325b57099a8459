// Processor seconds that large grammars take as text and as pictures: one line a grammar.

#include <cstdio>
#include <ctime>
#include <string>

#include "geometry/random.h"
#include "lsystem/derive.h"
#include "lsystem/grammar_text.h"
#include "lsystem/interpret.h"
#include "lsystem/number_text.h"
#include "lsystem/to_scene.h"

using namespace rinceau;

namespace {

template <class Work>
double seconds_of(Work work) {
    const std::clock_t start = std::clock();
    work();
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

constexpr const char* head = "lsystem 1\ncanvas 0 0 1000 1000\n";
constexpr const char* leaf = "style 1: fill #804020\nterminal A: style 1; path \"M0 0L4 0L4 4L0 4Z\"\n";

std::string numbered(const char* name, int number) { return name + std::to_string(number); }

/// Every leaf on its own in the axiom.
std::string placed(int count) {
    Random random(1);
    const auto number = [&](double most) { return number_text(most * random.uniform()); };
    std::string text = std::string(head) + "axiom:";
    for (int i = 0; i < count; ++i) {
        const bool wraps = i % 2 == 1;
        text += " [+(" + number(360) + ") f(" + number(1000) + ") *(" + number(2) + ") +(" + number(360) + ")";
        text += wraps ? " A]\n " : " A]";
    }
    return text + "\n" + leaf;
}

/// A row of which every leaf is an exception.
std::string excepted(int count) {
    std::string text = std::string(head) + "axiom: R(" + std::to_string(count) + ")\nR(m) : m > 0 -> [A] f(1) R(m-1)\n";
    for (int i = 1; i <= count; ++i) text += "except 1." + std::to_string(i) + " -> +(" + std::to_string(i % 360) + ") A\n";
    return text + leaf;
}

/// As many constants, productions, styles and terminals as leaves.
std::string named(int count) {
    std::string text = std::string(head) + "axiom:";
    for (int i = 1; i <= count; ++i) text += "\n  " + numbered("R", i);
    for (int i = 1; i <= count; ++i) text += "\ndefine " + numbered("c", i) + " = " + numbered("", i) + "/7";
    for (int i = 1; i <= count; ++i)
        text += '\n' + numbered("R", i) + " -> ;(" + numbered("", i) + ") f(" + numbered("c", i) + ") " + numbered("A", i);
    for (int i = 1; i <= count; ++i) text += '\n' + numbered("style ", i) + ": fill #804020";
    for (int i = 1; i <= count; ++i)
        text += '\n' + numbered("terminal A", i) + ": style " + numbered("", i) + "; path \"M0 0L4 0L4 4L0 4Z\"";
    return text + '\n';
}

void run(const char* name, int count, const std::string& text) {
    Grammar grammar;
    const double parse = seconds_of([&] { grammar = parse_grammar(text, "a grammar of some length.lsys"); });
    std::string printed;
    const double print = seconds_of([&] { printed = to_text(grammar); });
    std::size_t mistakes = 0;
    const double check = seconds_of([&] { mistakes = check_grammar(text).size(); });
    const double string = seconds_of([&] { to_text(derive(grammar)); });
    std::vector<Placement> placements;
    const double turtle = seconds_of([&] { placements = interpret(grammar, {.addresses = true}); });
    Scene scene;
    const double carry = seconds_of([&] { scene = to_scene(grammar, placements); });
    std::string picture;
    const double draw = seconds_of([&] { picture = grammar_svg(grammar, placements); });
    std::printf("%-9s %7d %9.1f %8zu  %7.3f %7.3f %7.3f %7.3f %9.3f %8.3f %11.3f\n", name, count,
                static_cast<double>(text.size()) / (1 << 20), mistakes, parse, print, check, string, turtle, carry, draw);
    std::fflush(stdout);
}

}  // namespace

int main() {
    std::printf("grammar     count  MiB text mistakes    parse   print   check  derive interpret to_scene grammar_svg\n");
    for (const int count : {10'000, 100'000}) {
        run("placed", count, placed(count));
        run("excepted", count, excepted(count));
        run("named", count, named(count));
    }
}
