#include <catch2/catch.hpp>

#include <map>

#include "analyzer/overlaps.h"
#include "analyzer/verify.h"
#include "closed_loop/known_grammar.h"
#include "closed_loop/random_grammar.h"
#include "closed_loop/scenes.h"

using namespace rinceau;
using namespace rinceau::test;

TEST_CASE("the known drawings have as many elements as they should") {
    const std::map<std::string, std::size_t> expected{
        {"fig8_sequence", 5}, {"fig5_linear", 9}, {"fig9_helix", 337}, {"fig10_facade", 72}, {"grid_20x30", 600},
        {"grid_turning", 180}, {"bricks", 320}, {"scales", 252}, {"facade_with_doors", 190}, {"footprints", 20},
        {"ring_chiral", 12}, {"ring_circles", 12}, {"rings_of_leaves", 96}, {"rings_of_circles", 96}, {"mandala", 129},
        {"clutter_40", 40}, {"clutter_500", 500}};
    const std::vector<KnownScene> scenes = known_scenes();
    CHECK(scenes.size() == expected.size());
    for (const KnownScene& known : scenes) {
        INFO(known.name);
        REQUIRE(expected.count(known.name) == 1);
        CHECK(known.scene.elements.size() == expected.at(known.name));
        CHECK(known.rules <= known.most_rules);
    }
    CHECK(nested_scene(1, 1).scene.elements.size() == 1200);
    CHECK(nested_scene(2, 5).scene.elements.size() == 12'000);
}

TEST_CASE("only scales and windows overlap in the known drawings that are not clutter") {
    for (const KnownScene& known : known_scenes()) {
        INFO(known.name);
        const bool overlapping = known.name == "scales" || known.name == "facade_with_doors" || known.rules == 0;
        CHECK((overlapping || find_overlaps(known.scene).pairs.empty()));
    }
}

TEST_CASE("randomly drawn grammars keep their elements apart and come again for the same seed") {
    for (const SampleKind kind : {SampleKind::sequence, SampleKind::linear, SampleKind::ring, SampleKind::grid, SampleKind::group,
                                  SampleKind::hierarchy}) {
        std::size_t touching = 0;
        std::size_t elements = 0;
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            const KnownGrammar known = random_known_grammar(kind, seed);
            const Scene scene = drawn_scene(known.grammar);
            CHECK(known.elements == static_cast<int>(scene.elements.size()));
            CHECK_FALSE(known.rules.empty());
            CHECK(drawn_scene(random_known_grammar(kind, seed).grammar).viewport == scene.viewport);
            elements += scene.elements.size();
            // Each colour by its place: what touches must show.
            Scene colored = scene;
            for (std::size_t i = 0; i < colored.elements.size(); ++i) {
                const Color color{static_cast<std::uint8_t>(i % 256), static_cast<std::uint8_t>(i / 256 % 256), 0};
                Style& style = colored.elements[i].style;
                if (paints_fill(style)) style.fill = color;
                if (paints_stroke(style)) style.stroke.paint = color;
            }
            touching += find_overlaps(colored).pairs.size();
        }
        INFO(static_cast<int>(kind));
        CHECK(touching * 50 < elements);
    }
}

TEST_CASE("a rounded drawing is its grammar's drawing to the rounding") {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        const KnownGrammar known = random_known_grammar(SampleKind::hierarchy, seed);
        Random random(seed);
        const Scene scene = shuffled(rounded(drawn_scene(known.grammar), 1e-3), random);
        const Verification found = verify(known.grammar, scene, {.tolerance = 1e-3});
        INFO(found.summary);
        CHECK(found.passed);
        CHECK(found.max_deviation > 0);
    }
}
