// Known branching grammars, drawn, rounded, shuffled and analysed (Stava et al. 2010, r3 and r4).

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <string>

#include "closed_loop/findings.h"
#include "closed_loop/known_grammar.h"
#include "closed_loop/shapes.h"
#include "lsystem/grammar_text.h"

using namespace rinceau;
using namespace rinceau::test;

namespace {

const std::string figure_1 = "R(m) : m > 0 -> [A] [-(17) f(64) *(0.8) -(3) R(m-1)] [+(7) f(181) *(0.6) +(23) R(m-1)]";

Element sized_hook(double size, Color color = {20, 30, 40}) { return placed(element(hook(), filled(color)), scale_by(size)); }

Grammar tree_of_hooks(const std::string& axiom, double size = 40) {
    return known_grammar("axiom: " + axiom + "\n" + figure_1, {{"A", sized_hook(size)}});
}

/// As drawing programs write them, in any order.
Scene drawn(const Grammar& grammar, std::uint64_t seed, double rounding = 1e-4) {
    Random random(seed);
    return shuffled(rounded(drawn_scene(grammar), rounding), random);
}

/// The grammar with another number in the calls of the axiom.
Grammar with_depth(Grammar grammar, int depth) {
    for (ModuleTemplate& module : grammar.axiom) {
        const bool counted = std::ranges::any_of(
            grammar.productions, [&](const Production& p) { return p.symbol == module.symbol && !p.parameters.empty(); });
        if (counted) module.arguments = {number_expression(depth)};
    }
    return grammar;
}

void check_draws(const Grammar& grammar, const Scene& wanted, double deviation) {
    const Verification check = verify(grammar, wanted);
    CHECK(check.unmatched == 0);
    CHECK(check.max_deviation < deviation);
}

}  // namespace

TEST_CASE("Fig. 1: a tree of any depth is one branching rule") {
    for (const int depth : {3, 4, 6, 10}) {
        const Analysis found = analyze(drawn(tree_of_hooks("R(" + std::to_string(depth) + ")"), 1));
        INFO(to_text(found.grammar));
        CHECK(rules_in_words(found.report) == "branching of " + std::to_string(depth));
        CHECK(axiom_symbols(found.grammar) == 1);
        CHECK(found.report.check.passed);
        CHECK(found.grammar.exceptions.empty());
    }
}

TEST_CASE("Fig. 1: the rule found in a small tree draws the large one") {
    const Analysis found = analyze(drawn(tree_of_hooks("R(4)"), 2, 1e-6));
    const Grammar large = tree_of_hooks("R(10)");
    check_draws(with_depth(found.grammar, 10), drawn_scene(large), 1e-3);
}

TEST_CASE("a tree among clutter of the same element is found, and the clutter stays") {
    const Scene tree = drawn_scene(tree_of_hooks("R(7)"));
    Scene scene = tree;
    Random random(5);
    for (int k = 0; k < 255; ++k) {
        const double scale = std::exp2(-4 * random.uniform());
        const Point place{scene.viewport.low.x + width(tree.viewport) * random.uniform(), scene.viewport.low.y + height(tree.viewport) * random.uniform()};
        scene.elements.push_back(placed(sized_hook(40), translate(place) * rotate(two_pi * random.uniform()) * scale_by(scale)));
    }
    const Analysis found = analyze(shuffled(rounded(scene, 1e-4), random));
    CHECK(rules_in_words(found.report) == "branching of 7");
    CHECK(axiom_symbols(found.grammar) == 256);
    CHECK(found.report.check.passed);
}

TEST_CASE("a forest of trees of two depths is one rule") {
    std::string axiom;
    for (int k = 0; k < 20; ++k) {
        axiom += "[f(" + std::to_string(700 * (k % 5) + 37 * (k * k % 7)) + ") -(90) f(" + std::to_string(900 * (k / 5)) + ") +(" + std::to_string(53 * k % 360) + ") *(" +
                 std::to_string(0.5 + 0.03 * (k * 7 % 20)) + ") R(" + std::to_string(k % 2 == 0 ? 5 : 6) + ")] ";
    }
    const Analysis found = analyze(drawn(tree_of_hooks(axiom), 3));
    CHECK(rules_in_words(found.report) == "branching of 5 6");
    CHECK(axiom_symbols(found.grammar) == 20);
    CHECK(found.report.check.passed);
}

TEST_CASE("a fern of three branches of a mirror-symmetric leaf is one rule") {
    const Grammar fern = known_grammar(
        "axiom: R(7)\nR(m) : m > 0 -> [A] [f(2.1) *(0.8) +(4) R(m-1)] [f(1) +(50) f(1.4) *(0.45) R(m-1)] [f(1.3) -(50) f(1.4) *(0.4) R(m-1)]",
        {{"A", element(leaf(), filled({30, 120, 40}))}});
    const Analysis found = analyze(drawn(fern, 4));
    INFO(to_text(found.grammar));
    CHECK(rules_in_words(found.report) == "branching of 7");
    CHECK(axiom_symbols(found.grammar) == 1);
    CHECK(found.report.check.passed);
}

TEST_CASE("a symmetric tree of strokes is one rule") {
    const Grammar tree = known_grammar(
        "axiom: R(9)\nR(m) : m > 0 -> [A] [f(2) +(31) *(0.71) R(m-1)] [f(2) -(31) *(0.71) R(m-1)]",
        {{"A", element({Path{{0, 0}, {line_to({0, 2})}}}, stroked({90, 60, 20}, 0.1))}});
    const Analysis found = analyze(drawn(tree, 5));
    INFO(to_text(found.grammar));
    CHECK(rules_in_words(found.report) == "branching of 9");
    CHECK(axiom_symbols(found.grammar) == 1);
    CHECK(found.report.check.passed);
}

TEST_CASE("a tree with other elements at its ends is one rule with an end") {
    const Grammar tree = known_grammar("axiom: R(6)\n" + figure_1 + "\nR(m) : m == 0 -> B",
                                       {{"A", sized_hook(40)}, {"B", placed(element(leaf(), filled({40, 160, 60})), scale_by(30))}});
    const Analysis found = analyze(drawn(tree, 6));
    INFO(to_text(found.grammar));
    CHECK(rules_in_words(found.report) == "branching of 6; branching of 6");  // and its end
    CHECK(axiom_symbols(found.grammar) == 1);
    CHECK(found.report.check.passed);
}

TEST_CASE("a tree of groups is one rule") {
    const Grammar tree = known_grammar(
        "axiom: R(5)\nR(m) : m > 0 -> [A] [f(90) B] [f(30) +(50) f(40) C] [-(17) f(64) *(0.8) -(3) R(m-1)] [+(7) f(181) *(0.6) +(23) R(m-1)]",
        {{"A", sized_hook(40)}, {"B", element(regular_polygon(5, 12), filled({200, 40, 40}))}, {"C", element(star(4), filled({20, 20, 200}))}});
    const Analysis found = analyze(drawn(tree, 7));
    INFO(to_text(found.grammar));
    CHECK(rules_in_words(found.report) == "branching of 5");
    CHECK(axiom_symbols(found.grammar) == 1);
    CHECK(found.report.check.passed);
}

TEST_CASE("a tree that changes its colour and its pen from level to level is one tree") {
    Grammar tree = known_grammar("axiom: R(5)\nR(m) : m > 0 -> [N(m)] [f(2) -(25) *(0.75) R(m-1)] [f(2) +(30) *(0.7) R(m-1)]\n"
                                 "N(m) : m == 5 -> A\nN(m) : m == 4 -> B\nN(m) : m == 3 -> C\nN(m) : m == 2 -> D\nN(m) : m == 1 -> E",
                                 {});
    for (int level = 0; level < 5; ++level) {
        const Element twig = element({Path{{0, 0}, {line_to({0, 2})}}}, stroked({std::uint8_t(150 - 30 * level), std::uint8_t(60 + 30 * level), 20}, 0.2 - 0.03 * level));
        tree.styles.push_back({.number = level + 1, .style = twig.style});
        tree.terminals.push_back({.symbol = std::string(1, char('A' + level)), .style = level + 1, .paths = twig.paths});
    }
    const Analysis found = analyze(drawn(tree, 8));
    INFO(to_text(found.grammar));
    CHECK(axiom_symbols(found.grammar) == 1);
    CHECK(found.report.productions.front().kind == "branching");
    CHECK(found.report.productions.front().lengths == std::vector<int>{5});
    CHECK(found.report.check.passed);
}

TEST_CASE("rows, grids, rings and spirals are no trees") {
    for (const KnownScene& known : known_scenes()) {
        const Analysis found = analyze(known.scene);
        INFO(known.name << ": " << rules_in_words(found.report));
        CHECK(std::ranges::none_of(found.report.productions, [](const ProductionReport& p) { return p.kind == "branching"; }));
    }
}
