// Rows whose step or size changes evenly (Stava et al. 2010, eq. 4), drawn, rounded, shuffled and analysed.

#include <catch2/catch.hpp>

#include <string>

#include "closed_loop/findings.h"
#include "closed_loop/known_grammar.h"
#include "closed_loop/shapes.h"
#include "lsystem/grammar_text.h"

using namespace rinceau;
using namespace rinceau::test;

namespace {

Element curl() { return element(transformed(hook(), scale_by(6)), filled({0, 120, 200})); }
Element dot() { return element(circle(4), filled({200, 20, 40})); }

Scene as_drawn(const Grammar& known) {
    Random random(7);
    return shuffled(rounded(drawn_scene(known), 1e-3), random);
}

void check_one_row(const std::string& rules, const Element& mark, int count) {
    const Analysis found = analyze(as_drawn(known_grammar(rules, {{"A", mark}})));
    INFO(rules << "\n" << to_text(found.grammar));
    CHECK(found.report.check.passed);
    CHECK(rules_in_words(found.report) == "linear of " + std::to_string(count));
    CHECK(axiom_symbols(found.grammar) == 1);
    CHECK(found.grammar.exceptions.empty());
}

}  // namespace

TEST_CASE("rows whose steps grow by the same, by the same factor, or whose members do, are one rule") {
    for (const Element& mark : {curl(), dot()}) {
        check_one_row("axiom: P(9)\nP(m) : m > 0 -> [A] -(90) f(14+3*m) +(90) P(m-1)", mark, 9);
        check_one_row("axiom: P(9)\nP(m) : m > 0 -> [A] -(90) f(20*1.2^m) +(90) P(m-1)", mark, 9);
        check_one_row("axiom: P(10)\nP(m) : m > 0 -> [*(0.5+0.1*m) A] -(90) f(24) +(90) P(m-1)", mark, 10);
        check_one_row("axiom: P(10)\nP(m) : m > 0 -> [*(0.5+0.1*m) A] f(8+2*m) P(m-1)", mark, 10);
    }
}

TEST_CASE("a step that turns more and more is found about any point of its element") {
    const Element tailed = element(transformed(hook(), translate({0, 7}) * scale_by(6)), filled({0, 120, 200}));
    for (const Element& mark : {curl(), tailed}) {
        check_one_row("axiom: P(9)\nP(m) : m > 0 -> [A] +(10+5*m) f(50) +(-20+4*m) P(m-1)", mark, 9);
    }
}

TEST_CASE("rows of one law stand in a row themselves") {
    const Analysis found = analyze(as_drawn(
        known_grammar("axiom: Q(5)\nQ(n) : n > 0 -> [P(8)] f(40) Q(n-1)\nP(m) : m > 0 -> [A] -(90) f(14+3*m) +(90) P(m-1)",
                      {{"A", curl()}})));
    INFO(to_text(found.grammar));
    CHECK(rules_in_words(found.report) == "linear of 8; sequence of 5");
    CHECK(axiom_symbols(found.grammar) == 1);
}
