// What must not change what is found: where the drawing lies, the order of its elements, threads, and what lies elsewhere.

#include <catch2/catch.hpp>

#include <string>
#include <utility>
#include <vector>

#include "closed_loop/findings.h"
#include "closed_loop/known_grammar.h"
#include "closed_loop/scenes.h"
#include "closed_loop/shapes.h"
#include "lsystem/grammar_text.h"

using namespace rinceau;
using namespace rinceau::test;

TEST_CASE("the same drawing gives the same bytes, on any number of threads") {
    for (const KnownScene& known : known_scenes()) {
        INFO(known.name);
        const std::string one = to_text(analyze(known.scene, {.threads = 1}).grammar);
        CHECK(one == to_text(analyze(known.scene, {.threads = 1}).grammar));
        CHECK(one == to_text(analyze(known.scene, {.threads = 2}).grammar));
    }
}

TEST_CASE("the order of elements that do not overlap changes no rule") {
    Random random(1);
    // In these two the order can be seen.
    for (const KnownScene& known : scenes_but({"scales", "facade_with_doors"})) {
        INFO(known.name);
        CHECK(rules_in_words(analyze(shuffled(known.scene, random)).report) == rules_in_words(analyze(known.scene).report));
    }
}

TEST_CASE("moved, turned, scaled and mirrored, a drawing has the same rules") {
    const std::vector<std::pair<std::string, Similarity>> maps{{"moved", translate({1234.5, -678.25})},
                                                               {"turned", rotate(radians(37))},
                                                               {"turned to the side", rotate(radians(90))},
                                                               {"larger", scale_by(17.3)},
                                                               {"smaller", scale_by(0.0123)},
                                                               {"mirrored", mirror_about_heading()},
                                                               {"all", {polar(2.5, 1.1), {-300, 40}, true}}};
    for (const KnownScene& known : scenes_but({"clutter_500", "grid_turning", "mandala"})) {
        const std::string rules = rules_in_words(analyze(carried(known.scene, {})).report);
        for (const auto& [name, map] : maps) {
            INFO(known.name << " " << name);
            const Analysis found = analyze(carried(known.scene, map));
            CHECK(found.report.check.passed);
            CHECK(rules_in_words(found.report) == rules);
        }
    }
}

TEST_CASE("an element far away changes only the axiom") {
    for (const KnownScene& known : known_scenes()) {
        INFO(known.name);
        const Analysis before = analyze(known.scene);
        Scene scene = known.scene;
        const double size = 0.1 * diagonal(scene.viewport);
        const Point far = scene.viewport.high + Point{size, size};
        scene.elements.push_back(placed(element(frame(5), filled({1, 2, 3})), {{size / 4, 0}, far, false}));
        scene.viewport = including(scene.viewport, painted_box(scene.elements.back()));
        const Analysis after = analyze(scene);
        CHECK(rules_in_words(after.report) == rules_in_words(before.report));
        CHECK(axiom_symbols(after.grammar) == axiom_symbols(before.grammar) + 1);
    }
}
