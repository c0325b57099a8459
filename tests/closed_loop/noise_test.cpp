// Irregular drawings give the rules of the regular ones (Stava et al. 2010, figure 10, with jitter), and are drawn as they
// are.

#include <catch2/catch.hpp>

#include "closed_loop/findings.h"
#include "closed_loop/noisy_scenes.h"
#include "closed_loop/scenes.h"
#include "lsystem/interpret.h"
#include "lsystem/to_scene.h"

using namespace rinceau;
using namespace rinceau::test;

TEST_CASE(
    "Drawings jittered by up to a fifth of their spacing give the rules of the regular ones and come back as they are") {
    const auto [name, largest] = GENERATE(table<std::string, double>({{"fig10_facade", 0.20},
                                                                      {"grid_12x15", 0.20},
                                                                      {"ring_12", 0.10},
                                                                      {"rings_12x8", 0.05},
                                                                      {"staggered_rows", 0.10},
                                                                      {"circles_8x10", 0.20}}));
    for (const double jitter : {0.02, 0.05, 0.10, 0.20}) {
        if (jitter > largest) continue;
        for (const std::uint64_t seed : {101u}) {
            CAPTURE(name, jitter, seed);
            const NoisyScene scene = noisy_scene(name, jitter, seed);
            const Analysis found = analyze(scene.drawn);
            CHECK(rules_in_words(found.report) == scene.rules);
            CHECK(axiom_symbols(found.grammar) == 1);
            CHECK(found.report.check.passed);
            CHECK(found.report.grammar_bits < found.report.drawing_bits);
        }
    }
}

TEST_CASE("Symmetrized, a drawing is at most a third as far from what was meant") {
    const std::string name = GENERATE("fig10_facade", "grid_12x15", "rings_12x8", "circles_8x10");
    const NoisyScene scene = noisy_scene(name, 0.10, 101);
    const Analysis found = analyze(scene.drawn, {.symmetrize = true});
    CAPTURE(name);
    CHECK(rules_in_words(found.report) == scene.rules);
    CHECK(found.grammar.exceptions.empty());
    CHECK(found.report.check.passed);
    const Scene layout = drawn_in_order_of(scene.regular, to_scene(found.grammar, interpret(found.grammar)));
    CHECK(rms_distance(scene.regular, layout) <= rms_distance(scene.regular, scene.drawn) / 3);
    // The report says by how much the drawing differs.
    CHECK(found.report.check.rms_deviation * drawing_diagonal(scene.drawn) ==
          Approx(rms_distance(scene.regular, scene.drawn)).epsilon(0.1));
}

TEST_CASE("Stochastic, a drawing becomes a family whose members differ from what was meant by as much as it does") {
    const std::string name = GENERATE("fig10_facade", "grid_12x15", "circles_8x10");
    CAPTURE(name);
    const NoisyScene scene = noisy_scene(name, 0.10, 101);
    const Analysis found = analyze(scene.drawn, {.stochastic = true});
    CHECK(rules_in_words(found.report) == scene.rules);
    CHECK(found.grammar.exceptions.empty());
    CHECK(found.report.check.passed);
    const double drawn = rms_distance(scene.regular, scene.drawn);
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
        const Scene relative = to_scene(found.grammar, interpret(found.grammar, {.derive = {.seed = seed}}));
        CHECK(relative.elements.size() == scene.regular.elements.size());
        CHECK(rms_distance(scene.regular, drawn_in_order_of(scene.regular, relative)) == Approx(drawn).epsilon(0.25));
    }
}

TEST_CASE("What stands nowhere in particular is in no row and no ring") {
    for (const std::uint64_t seed : {1u, 2u, 3u, 4u, 5u}) {
        for (const int count : {6, 12, 40, 150}) {
            const Analysis found = analyze(clutter_scene(count, {.seed = seed}).scene);
            CAPTURE(seed, count);
            CHECK(found.report.productions.empty());
        }
    }
}
