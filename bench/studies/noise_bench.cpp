// How much irregularity the rules survive: for each drawing and jitter, how many of 20 seeds give the rules of the regular
// drawing, and the root mean square distance of its elements from the regular drawing, as drawn and with --symmetrize.
// Usage: noise_bench [name of a scene] [-v: what else was found], or, to look at one: noise_bench NAME JITTER SEED OUT.svg

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include "analyzer/analyze.h"
#include "closed_loop/findings.h"
#include "closed_loop/noisy_scenes.h"
#include "lsystem/interpret.h"
#include "lsystem/to_scene.h"
#include "scene/svg_write.h"

using namespace rinceau;
using namespace rinceau::test;

namespace {

constexpr int seeds = 20;

void run(const std::string& name, double jitter, bool verbose) {
    int right = 0;
    double ratio = 0, drawn_off = 0, layout_off = 0;
    double seconds = 0;
    for (int seed = 1; seed <= seeds; ++seed) {
        const NoisyScene scene = noisy_scene(name, jitter, static_cast<std::uint64_t>(seed));
        const auto start = std::chrono::steady_clock::now();
        const Analysis found = analyze(scene.drawn);
        const std::string rules = rules_in_words(found.report);
        const bool as_meant = rules == scene.rules && axiom_symbols(found.grammar) == 1 && found.report.check.passed;
        right += as_meant;
        if (verbose && !as_meant) {
            std::printf("  seed %d: %s | axiom %d | %.0f of %.0f bits\n", seed, rules.c_str(), axiom_symbols(found.grammar),
                        found.report.grammar_bits, found.report.drawing_bits);
        }
        ratio += found.report.drawing_bits / found.report.grammar_bits / seeds;
        seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / seeds;
        const Analysis symmetrized = analyze(scene.drawn, {.symmetrize = true});
        const Scene layout = drawn_in_order_of(scene.regular, to_scene(symmetrized.grammar, interpret(symmetrized.grammar)));
        drawn_off += rms_distance(scene.regular, scene.drawn) / scene.spacing / seeds;
        layout_off += rms_distance(scene.regular, layout) / scene.spacing / seeds;
    }
    std::printf("%-16s %5.0f %%  %2d of %d  %7.2f  %8.4f  %8.4f  %8.3f\n", name.c_str(), 100 * jitter, right, seeds, ratio, drawn_off,
                layout_off, seconds);
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    if (arguments.size() == 4) {
        const NoisyScene scene = noisy_scene(arguments[0], std::stod(arguments[1]), std::stoull(arguments[2]));
        std::ofstream(arguments[3]) << write_svg(scene.drawn);
        return 0;
    }
    const bool verbose = std::ranges::find(arguments, "-v") != arguments.end();
    const std::string only = arguments.empty() || arguments[0] == "-v" ? "" : arguments[0];
    std::printf("%-16s %7s  %8s  %7s  %8s  %8s  %8s\n", "scene", "jitter", "as meant", "ratio", "rms", "regular", "seconds");
    for (const std::string& name : noisy_scene_names()) {
        if (!only.empty() && only != name) continue;
        for (const double jitter : {0.0, 0.02, 0.05, 0.10, 0.15, 0.20}) run(name, jitter, verbose);
    }
}
