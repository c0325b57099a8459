#include "how_to/knockout_rule.h"

#include <catch2/catch.hpp>

#include <algorithm>

#include "analyzer/analyze.h"
#include "geometry/random.h"
#include "lsystem/grammar_text.h"
#include "lsystem/interpret.h"
#include "lsystem/to_scene.h"
#include "scene/svg_read.h"
#include "scene/svg_write.h"

using namespace rinceau;

namespace {

/// A plan as a drawing program writes it: flat, with coordinates of three decimals. `axiom` is where it stands and how
/// large.
Scene drawn(const std::string& axiom, double way, double half) {
    const std::string rule = "Knockout(m) : m > 0 -> [A] [f(" + std::to_string(way) + ") +(90) f(" + std::to_string(half) +
                             "*2^(m-1)) -(90) Knockout(m-1)] [f(" + std::to_string(way) + ") -(90) f(" +
                             std::to_string(half) + "*2^(m-1)) +(90) Knockout(m-1)]\nKnockout(m) : m == 0 -> [A]\n";
    const Grammar grammar = parse_grammar("lsystem 1\ncanvas -700 -700 1400 1400\naxiom: " + axiom + "\n" + rule +
                                          "style 1: fill #204080\nterminal A: style 1; path \"M-9 0L6 4L5 -7Z\"\n");
    Scene scene = to_scene(grammar, interpret(grammar));
    constexpr double decimals = 1e3;
    const auto rounded = [](Point p) {
        return Point{std::round(p.x * decimals) / decimals, std::round(p.y * decimals) / decimals};
    };
    for (Element& element : scene.elements)
        for (Path& path : element.paths) {
            path.start = rounded(path.start);
            for (Segment& segment : path.segments)
                segment = {rounded(segment.control1), rounded(segment.control2), rounded(segment.to), segment.straight};
        }
    return scene;
}

std::size_t drawn_elements(const Grammar& grammar) { return interpret(grammar).size(); }

}  // namespace

TEST_CASE("known plan, drawing, the same plan again: whatever side the final stands on, in whatever order it is drawn") {
    Random random(7);
    for (const std::string turn : {"+(0)", "+(90)", "+(180)", "-(90)"}) {
        for (const int rounds : {3, 4, 5}) {
            const double way = random.uniform(20, 90), half = random.uniform(8, 20);
            Scene scene = drawn(
                "f(" + std::to_string(random.uniform(-100, 100)) + ") " + turn + " Knockout(" + std::to_string(rounds) + ")",
                way, half);
            for (std::size_t i = scene.elements.size(); i > 1; --i)
                std::swap(scene.elements[i - 1], scene.elements[random.below(static_cast<std::uint32_t>(i))]);
            const std::optional<Grammar> found = knockout_grammar(scene);
            CAPTURE(turn, rounds, way, half);
            REQUIRE(found);
            CHECK(found->productions.size() == 2);
            CHECK(drawn_elements(*found) == scene.elements.size());
            const auto& axiom = found->axiom.back();
            CHECK(axiom.symbol == "Knockout");
            CHECK(to_text(axiom.arguments.front()) == std::to_string(rounds));
        }
    }
}

TEST_CASE("the rule is a rule: with one round more it draws the larger plan") {
    std::optional<Grammar> found = knockout_grammar(drawn("Knockout(3)", 40, 12));
    REQUIRE(found);
    found->axiom.back().arguments.front() = number_expression(4);
    CHECK(drawn_elements(*found) == 31);
}

TEST_CASE("it says in one symbol what the search says in rows and single elements") {
    const Scene scene = drawn("Knockout(4)", 60, 14);
    const Analysis known = analyze(scene);
    CHECK(known.report.check.passed);
    CHECK(known.grammar.productions.size() + known.grammar.axiom.size() > 4);
    const std::optional<Grammar> found = knockout_grammar(scene);
    REQUIRE(found);
    CHECK(to_text(*found).size() < to_text(known.grammar).size());
}

TEST_CASE("what is no plan gives no rule: a place missing, one too many, one off, one turned, clutter, too few rounds") {
    const Scene plan = drawn("Knockout(3)", 40, 12);
    REQUIRE(knockout_grammar(plan));
    Scene missing = plan;
    missing.elements.pop_back();
    CHECK_FALSE(knockout_grammar(missing));
    Scene more = plan;
    more.elements.push_back(more.elements.front());
    for (Path& path : more.elements.back().paths) path = transformed(path, Affine{1, 0, 0, 1, 300, 5});
    CHECK_FALSE(knockout_grammar(more));
    for (const Affine& map : {Affine{1, 0, 0, 1, 2, 0}, Affine{0, 1, -1, 0, 0, 0}, Affine{1.2, 0, 0, 1.2, 0, 0}}) {
        Scene other = plan;
        for (Path& path : other.elements[5].paths) path = transformed(path, map);
        CHECK_FALSE(knockout_grammar(other));
    }
    CHECK_FALSE(knockout_grammar(drawn("Knockout(2)", 40, 12)));
    Random random(3);
    for (int drawing = 0; drawing < 50; ++drawing) {
        Scene clutter = plan;
        for (Element& element : clutter.elements)
            for (Path& path : element.paths)
                path = transformed(path, Affine{1, 0, 0, 1, random.uniform(-300, 300), random.uniform(-300, 300)});
        CHECK_FALSE(knockout_grammar(clutter));
    }
    CHECK_FALSE(knockout_grammar(Scene{}));
}
