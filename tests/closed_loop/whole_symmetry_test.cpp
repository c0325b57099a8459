// Drawings that are their own image under a turn or a mirror: one sector or half is found, and what makes the whole of it.

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>
#include <vector>

#include "analyzer/analyze.h"
#include "analyzer/scene_symmetry.h"
#include "closed_loop/findings.h"
#include "closed_loop/known_grammar.h"
#include "closed_loop/shapes.h"
#include "geometry/random.h"
#include "lsystem/grammar_text.h"

using namespace rinceau;
using namespace rinceau::test;

namespace {

/// `count` elements of as many kinds in a box.
std::vector<Element> motif(int count, const Box& where, Random& random) {
    std::vector<Element> elements;
    for (int k = 0; k < count; ++k) {
        const double x = random.uniform(where.low.x, where.high.x), y = random.uniform(where.low.y, where.high.y);
        const Similarity pose{polar(random.uniform(3, 6), random.uniform(-pi, pi)), {x, y}, false};
        elements.push_back(placed(element(blob(5 + k % 4, random), filled(random_color(random))), pose));
    }
    return elements;
}

void add(Scene& scene, const Element& element) {
    scene.elements.push_back(element);
    scene.viewport = including(scene.viewport, painted_box(element));
}

/// The images of the motif under n turns about the origin, moved.
void add_turned(Scene& scene, const std::vector<Element>& motif, int n, Point centre = {}) {
    for (int k = 0; k < n; ++k) {
        for (const Element& each : motif) add(scene, placed(each, translate(centre) * rotate(two_pi * k / n)));
    }
}

std::vector<Element> with_mirror_image(std::vector<Element> half) {
    const std::size_t count = half.size();
    for (std::size_t k = 0; k < count; ++k) half.push_back(placed(half[k], mirror_about_heading()));
    return half;
}

Scene as_drawn(const Scene& scene, Random& random) { return shuffled(rounded(scene, 1e-3), random); }

SearchState state_of(const Scene& scene) {
    return starting_state(group_similar_elements(scene), {}, diagonal(scene.viewport));
}

constexpr Box sector_box{{8, 60}, {24, 160}};

}  // namespace

TEST_CASE("a sector of two mirrored halves is found as such") {
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
        Random random(seed);
        Scene scene;
        add_turned(scene, with_mirror_image(motif(6, sector_box, random)), 6);
        const Scene drawing = as_drawn(scene, random);
        const auto symmetries = find_scene_symmetries(state_of(drawing));
        REQUIRE_FALSE(symmetries.empty());
        CHECK(symmetries.front().group.fold == 6);
        CHECK(symmetries.front().group.mirrored);
        CHECK(symmetries.front().orbits.size() == 6);
        const Analysis found = analyze(drawing);
        INFO("seed " << seed << "\n" << to_text(found.grammar));
        // A ring of mirrored pairs; the pair is a mirrored sequence, or two halves about an axis.
        const std::string rules = rules_in_words(found.report);
        CHECK((rules == "group of 2; group of 6; ring of 6" || rules == "group of 6; ring of 6; sequence of 2"));
        CHECK(axiom_symbols(found.grammar) == 1);
        CHECK(found.report.check.passed);
    }
}

TEST_CASE("a face is two halves and what stands on the axis") {
    Random random(7);
    Scene scene;
    for (const Element& each : with_mirror_image(motif(12, {{8, 0}, {80, 100}}, random))) add(scene, each);
    add(scene, placed(element(leaf(), filled({200, 0, 0})), {{8, 0}, {0, 50}, false}));
    const Analysis found = analyze(as_drawn(scene, random));
    INFO(to_text(found.grammar));
    CHECK(rules_in_words(found.report) == "group of 12; group of 2");
    CHECK(axiom_symbols(found.grammar) == 2);
    CHECK(to_text(found.grammar).find("two mirror halves") != std::string::npos);
}

TEST_CASE("turns about a centre are found whatever stands beside them") {
    Random random(3);
    Scene scene;
    add_turned(scene, motif(10, sector_box, random), 5);
    for (const Element& each : motif(12, {{-150, -215}, {150, -190}}, random)) add(scene, each);
    const Scene drawing = as_drawn(scene, random);
    const auto symmetries = find_scene_symmetries(state_of(drawing));
    REQUIRE(symmetries.size() == 1);
    CHECK(symmetries.front().group.fold == 5);
    CHECK_FALSE(symmetries.front().group.mirrored);
    CHECK(symmetries.front().orbits.size() == 10);
    CHECK(abs(symmetries.front().group.centre) < 0.05);
    const Analysis found = analyze(drawing);
    INFO(to_text(found.grammar));
    CHECK(rules_in_words(found.report) == "group of 10; ring of 5");
    CHECK(axiom_symbols(found.grammar) == 13);
}

TEST_CASE("two mandalas side by side are two rings") {
    Random random(4);
    Scene scene;
    add_turned(scene, motif(8, sector_box, random), 5);
    add_turned(scene, motif(6, sector_box, random), 7, {420, 0});
    const Analysis found = analyze(as_drawn(scene, random));
    INFO(to_text(found.grammar));
    CHECK(rules_in_words(found.report) == "group of 6; group of 8; ring of 5; ring of 7");
    CHECK(axiom_symbols(found.grammar) == 2);
}

TEST_CASE("orbits are what their maps say") {
    Random random(9);
    Scene scene;
    add_turned(scene, with_mirror_image(motif(4, sector_box, random)), 8);
    // Two rings on the two kinds of mirror axes.
    for (int k = 0; k < 8; ++k) {
        add(scene, placed(element(leaf(), filled({9, 9, 9})), rotate(two_pi * k / 8) * translate({0, 40}) * scale_by(4)));
        add(scene, placed(element(star(5), filled({5, 9, 9})), rotate(two_pi * (k + 0.5) / 8) * translate({0, 45}) * scale_by(4)));
    }
    const SearchState state = state_of(as_drawn(scene, random));
    const auto symmetries = find_scene_symmetries(state);
    REQUIRE_FALSE(symmetries.empty());
    const SceneSymmetry& symmetry = symmetries.front();
    REQUIRE(symmetry.group.fold == 8);
    REQUIRE(symmetry.group.mirrored);
    CHECK(symmetry.orbits.size() == 6);
    int on_axis = 0;
    for (const std::vector<int>& orbit : symmetry.orbits) {
        REQUIRE(orbit.size() == symmetry.group.order());
        on_axis += symmetry.on_axis(orbit) ? 1 : 0;
        const Point first = state.item(orbit.front()).pose.translation;
        for (std::size_t k = 0; k < orbit.size(); ++k) {
            CHECK(abs(apply(symmetry.group.map(k), first) - state.item(orbit[k]).pose.translation) < 0.1);
        }
    }
    CHECK(on_axis == 2);
}

TEST_CASE("chance has no symmetry") {
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
        Random random(seed);
        Scene scene;
        for (int k = 0; k < 300; ++k) {
            const Element kind = k % 2 == 0 ? element(circle(1), filled({1, 0, 0})) : element(rectangle(2, 2), filled({2, 0, 0}));
            const double angle = random.uniform(-pi, pi), x = random.uniform(0, 200), y = random.uniform(0, 200);
            add(scene, placed(kind, {polar(1, angle), {x, y}, false}));
        }
        CHECK(find_scene_symmetries(state_of(scene)).empty());
    }
}
