// Classical self-similar curves and plants, drawn segment by segment and analysed: each is one recursive rule.

#include <catch2/catch.hpp>

#include <string>

#include "closed_loop/findings.h"
#include "closed_loop/known_grammar.h"
#include "closed_loop/shapes.h"
#include "lsystem/grammar_text.h"

using namespace rinceau;
using namespace rinceau::test;

namespace {

/// F(0) draws a segment and goes to its end.
Grammar curve(const std::string& rules) {
    return known_grammar(rules + "\nF(n) : n == 0 -> L f(1)\nG(n) : n == 0 -> L f(1)",
                         {{"L", element({Path{{0, 0}, {line_to({0, 1})}}}, stroked({0, 0, 0}, 0.1))}});
}

struct KnownCurve {
    std::string name;
    std::string rules;
    std::size_t copies;
    int depth;
};

const std::vector<KnownCurve> known_curves{
    {"Koch", "axiom: F(4)\nF(n) : n > 0 -> F(n-1) +(60) F(n-1) -(120) F(n-1) +(60) F(n-1)", 4, 4},
    {"quadratic Koch", "axiom: F(3)\nF(n) : n > 0 -> F(n-1) -(90) F(n-1) +(90) F(n-1) +(90) F(n-1) F(n-1) -(90) F(n-1) -(90) F(n-1) +(90) F(n-1)", 8, 3},
    {"quadratic Koch of five", "axiom: F(3)\nF(n) : n > 0 -> F(n-1) +(90) F(n-1) -(90) F(n-1) -(90) F(n-1) +(90) F(n-1)", 5, 3},
    {"dragon", "axiom: F(8)\nF(n) : n > 0 -> F(n-1) +(90) G(n-1)\nG(n) : n > 0 -> F(n-1) -(90) G(n-1)", 2, 8},
    {"Gosper", "axiom: F(3)\nF(n) : n > 0 -> F(n-1) -(60) G(n-1) -(120) G(n-1) +(60) F(n-1) +(120) F(n-1) F(n-1) +(60) G(n-1) -(60)\n"
               "G(n) : n > 0 -> +(60) F(n-1) -(60) G(n-1) G(n-1) -(120) G(n-1) -(60) F(n-1) +(120) F(n-1) +(60) G(n-1)", 7, 3},
    {"arrowhead", "axiom: F(5)\nF(n) : n > 0 -> G(n-1) -(60) F(n-1) -(60) G(n-1)\nG(n) : n > 0 -> F(n-1) +(60) G(n-1) +(60) F(n-1)", 3, 5},
    {"Levy", "axiom: F(8)\nF(n) : n > 0 -> +(45) F(n-1) -(90) F(n-1) +(45)", 2, 8},
    {"plant", "axiom: F(3)\nF(n) : n > 0 -> F(n-1) [+(25.7) F(n-1)] F(n-1) [-(25.7) F(n-1)] F(n-1)", 5, 3},
};

std::size_t copies_in(const Grammar& grammar) {
    std::size_t copies = 0;
    for (const ModuleTemplate& module : grammar.productions.front().successor) copies += module.symbol == grammar.productions.front().symbol;
    return copies;
}

}  // namespace

TEST_CASE("curves and plants made of small copies of themselves are one recursive rule each") {
    for (const KnownCurve& known : known_curves) {
        const Analysis found = analyze(rounded(drawn_scene(curve(known.rules)), 1e-4));
        INFO(known.name << "\n" << to_text(found.grammar));
        CHECK(found.report.check.passed);
        CHECK(axiom_symbols(found.grammar) == 1);
        REQUIRE(found.grammar.productions.size() == 2);  // the rule, and what stands at depth 0
        CHECK(found.grammar.productions[0].symbol == found.grammar.productions[1].symbol);
        CHECK(found.report.productions.front().kind == "branching");
        CHECK(found.report.productions.front().lengths == std::vector<int>{known.depth});
        CHECK(copies_in(found.grammar) == known.copies);
        CHECK(found.report.grammar_bits < 0.1 * found.report.drawing_bits);
    }
}

TEST_CASE("a walk at random has no rule, and a row of strokes is a row") {
    Random random(3);
    std::string walk, row;
    for (int k = 0; k < 256; ++k) {
        walk += "L f(1) +(" + std::to_string(90 * static_cast<int>(random.below(4))) + ") ";
        row += "[f(" + std::to_string(3 * k) + ") L] ";
    }
    const Analysis lost = analyze(drawn_scene(curve("axiom: " + walk)));
    for (const ProductionReport& production : lost.report.productions) CHECK(production.kind != "branching");
    const Analysis found = analyze(drawn_scene(curve("axiom: " + row)));
    CHECK(rules_in_words(found.report) == "sequence of 256");
}
