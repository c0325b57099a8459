// What the analysis finds in the known drawings, and how long it takes: one line a scene.
// Usage: analyze_bench [largest number of elements, default 12000]

#include <charconv>
#include <chrono>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "analyzer/analyze.h"
#include "closed_loop/scenes.h"
#include "lsystem/turtle_commands.h"

using namespace rinceau;
using namespace rinceau::test;

namespace {

int axiom_symbols(const Grammar& grammar) {
    int symbols = 0;
    for (const ModuleTemplate& module : grammar.axiom) symbols += find_turtle_command(module.symbol) == nullptr;
    return symbols;
}

void run(const KnownScene& known) {
    const auto start = std::chrono::steady_clock::now();
    const Analysis analysis = analyze(known.scene);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    const AnalysisReport& report = analysis.report;
    const double ratio = report.grammar_bits > 0 ? report.drawing_bits / report.grammar_bits : 0;
    std::printf("%-20s %7d  %3d-%-3d %6d  %4zu %6d  %8.1f  %9.1e  %7.3f  %s\n", known.name.c_str(), report.elements, known.rules,
                known.most_rules, known.axiom_symbols, report.productions.size(), axiom_symbols(analysis.grammar), ratio,
                report.check.max_deviation, seconds.count(), report.check.passed ? "" : report.check.summary.c_str());
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    std::size_t largest = 12'500;
    if (argc > 1) {
        const std::string_view text = argv[1];
        if (std::from_chars(text.data(), text.data() + text.size(), largest).ec != std::errc{}) {
            std::fputs("usage: analyze_bench [largest number of elements]\n", stderr);
            return 2;
        }
    }
    std::printf("%-20s %7s  %7s %6s  %4s %6s  %8s  %9s  %7s\n", "scene", "N", "rules", "axiom", "found", "axiom", "ratio", "deviation", "seconds");
    for (const KnownScene& known : known_scenes()) run(known);
    for (const int count : {1'000, 10'000, 100'000}) {
        if (static_cast<std::size_t>(count) <= largest) run(clutter_scene(count));
    }
    for (const auto& [rows, columns] : {std::pair{1, 1}, std::pair{2, 5}, std::pair{7, 12}}) {
        if (static_cast<std::size_t>(1200 * rows * columns) <= largest) run(nested_scene(rows, columns));
    }
}
