// Figures of Stava et al. 2010, drawn, rounded, shuffled and analysed.

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>
#include <vector>

#include "closed_loop/findings.h"
#include "closed_loop/known_grammar.h"
#include "closed_loop/scenes.h"
#include "lsystem/interpret.h"
#include "lsystem/to_scene.h"

using namespace rinceau;
using namespace rinceau::test;

namespace {

Scene known_scene(const std::string& name, double rounding = 1e-3) {
    const std::vector<KnownScene> scenes = known_scenes({.rounding = rounding});
    return std::ranges::find(scenes, name, &KnownScene::name)->scene;
}

Box box_of(const Scene& scene, std::size_t index) { return bounds(scene.elements[index].paths); }

std::size_t smallest_element(const Scene& scene) {
    std::size_t smallest = 0;
    for (std::size_t i = 1; i < scene.elements.size(); ++i) {
        if (diagonal(box_of(scene, i)) < diagonal(box_of(scene, smallest))) smallest = i;
    }
    return smallest;
}

}  // namespace

TEST_CASE("Fig. 10: a facade of 72 windows is four nested sequences and one symbol") {
    const Analysis found = analyze(known_scene("fig10_facade"));
    CHECK(found.report.elements == 72);
    CHECK(rules_in_words(found.report) == "sequence of 2; sequence of 3; sequence of 3; sequence of 4");
    CHECK(axiom_symbols(found.grammar) == 1);
    CHECK(found.report.check.passed);
}

TEST_CASE("Fig. 9: a helix of 337 is one sequence that ends where the drawing ends") {
    const Scene scene = known_scene("fig9_helix");
    const Analysis found = analyze(scene);
    CHECK(rules_in_words(found.report) == "sequence of 337");
    CHECK(axiom_symbols(found.grammar) == 1);
    CHECK(found.grammar.exceptions.empty());
    // Against the drawing before its coordinates were rounded; the rounding itself moves elements by up to 1e-3 of their size.
    const Scene exact = known_scene("fig9_helix", 0);
    const Scene drawn = to_scene(found.grammar, interpret(found.grammar));
    const Box wanted = box_of(exact, smallest_element(exact)), last = box_of(drawn, smallest_element(drawn));
    CHECK(abs(center(last) - center(wanted)) < 2e-3 * diagonal(wanted));
    CHECK(diagonal(last) == Approx(diagonal(wanted)).epsilon(1e-3));
}

TEST_CASE("Fig. 8: five elements of equal steps are one sequence") {
    const Analysis found = analyze(known_scene("fig8_sequence"));
    CHECK(rules_in_words(found.report) == "sequence of 5");
    CHECK(axiom_symbols(found.grammar) == 1);
}
