// A shape that is drawn twice in one place is listed twice there; rules are for what stands in several places.
#include <catch2/catch.hpp>

#include "analyzer/analyze.h"
#include "analyzer/lone_stacks.h"
#include "closed_loop/shapes.h"

using namespace rinceau;
using namespace rinceau::test;

namespace {

constexpr Color red{200, 0, 0}, blue{0, 0, 200};

/// Leaves of several sizes, angles and heights, each drawn `times` in the colours by turns, and a hook.
Scene stacked_leaves(int leaves, int times, const std::vector<Color>& colours) {
    Scene scene{{{-20, -20}, {400, 200}}, true, {}};
    for (int k = 0; k < leaves; ++k) {
        const Similarity place = translate({37.0 * k + 3.0 * (k % 3), 11.0 * ((k * k) % 7)}) * rotate(0.7 * k * k) *
                                 scale_by(6 + 1.3 * ((5 * k) % 4));
        for (int copy = 0; copy < times; ++copy)
            scene.elements.push_back(
                placed(element(leaf(), filled(colours[static_cast<std::size_t>(copy) % colours.size()])), place));
    }
    scene.elements.push_back(placed(element(hook(), filled({})), translate({150, 120}) * scale_by(9)));
    return scene;
}

}  // namespace

TEST_CASE("one shape drawn twice in one place needs no rule") {
    const Analysis found = analyze(stacked_leaves(1, 2, {red}));
    CHECK(found.report.check.passed);
    CHECK(found.report.productions.empty());
    CHECK(found.grammar.terminals.size() == 2);
    CHECK(found.report.axiom.find("[ A ] [ A ]") != std::string::npos);
    CHECK(found.report.grammar_bits < found.report.drawing_bits);
}

TEST_CASE("copies in other colours lie there as well, and are painted in the drawing's order") {
    const Analysis found = analyze(stacked_leaves(1, 3, {red, blue}));
    CHECK(found.report.check.passed);
    CHECK(found.report.productions.empty());
}

TEST_CASE("a stack that stands in several places is a rule") {
    const Analysis found = analyze(stacked_leaves(5, 2, {red, blue}));
    CHECK(found.report.check.passed);
    REQUIRE(found.report.productions.size() == 1);
    CHECK(found.report.productions.front().kind == "group");
    CHECK(found.report.productions.front().instances == 5);
}

TEST_CASE("of the parts of a drawing those are lone stacks that one root alone uses") {
    RuleSet rules;
    rules.rules.push_back({.kind = RuleKind::group, .members = {{0, {}}, {0, {}}}});
    rules.parts.push_back({.look = 0, .shape = 0});
    rules.parts.push_back({.rule = 0, .children = {{0, {}}, {0, {}}}});
    const auto put = [&](Point at) {
        const int first = static_cast<int>(rules.items.size());
        for (int k = 0; k < 2; ++k)
            rules.items.push_back({.part = 0, .pose = translate(at), .element = first + k, .alive = false});
        rules.items.push_back({.part = 1, .pose = translate(at), .members = {first, first + 1}});
    };
    put({5, 5});
    CHECK(lone_stacks(rules, root_items(rules), 0.1) == std::vector<bool>{false, true});
    rules.items[1].pose = translate({5.2, 5});
    CHECK(lone_stacks(rules, root_items(rules), 0.1) == std::vector<bool>{false, false});
    rules.items[1].pose = translate({5.05, 5});
    CHECK(lone_stacks(rules, root_items(rules), 0.1) == std::vector<bool>{false, true});
    put({50, 5});
    CHECK(lone_stacks(rules, root_items(rules), 0.1) == std::vector<bool>{false, false});
}
