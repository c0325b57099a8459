// Rows whose counts progress, drawn, rounded, shuffled and analysed.

#include <catch2/catch.hpp>

#include <string>

#include "closed_loop/findings.h"
#include "closed_loop/known_grammar.h"
#include "closed_loop/shapes.h"
#include "lsystem/grammar_text.h"
#include "lsystem/interpret.h"

using namespace rinceau;
using namespace rinceau::test;

namespace {

const std::string row = "P(m) : m > 0 -> [A] -(90) f(5) +(90) P(m-1)\n";
const Element tile = element(rectangle(3, 2), filled({180, 90, 60}));

Analysis found_again(const std::string& rules) {
    Random random(3);
    return analyze(shuffled(rounded(drawn_scene(known_grammar(rules + row, {{"A", tile}})), 1e-3), random));
}

}  // namespace

TEST_CASE("a triangle of rows is two rules, however its rows are aligned") {
    for (const char* shift : {"", "-(90) f(2.5) +(90)", "-(90) f(5) +(90)", "+(90) f(1) -(90)"}) {
        const Analysis found = found_again("axiom: T(12)\nT(m) : m > 0 -> [P(m)] f(5) " + std::string(shift) + " T(m-1)\n");
        INFO(shift << "\n" << to_text(found.grammar));
        CHECK(found.report.check.passed);
        CHECK(found.grammar.productions.size() == 2);
        CHECK(axiom_symbols(found.grammar) == 1);
        CHECK(found.grammar.exceptions.empty());
    }
}

TEST_CASE("counts may go by twos and need not end at one") {
    for (const char* rules : {"axiom: T(8)\nT(m) : m > 0 -> [P(2*m+1)] f(5) -(90) f(5) +(90) T(m-1)\n",
                              "axiom: T(5)\nT(m) : m > 0 -> [P(m+4)] f(7) T(m-1)\n"}) {
        const Analysis found = found_again(rules);
        INFO(rules << to_text(found.grammar));
        CHECK(found.report.check.passed);
        CHECK(found.grammar.productions.size() == 2);
        CHECK(axiom_symbols(found.grammar) == 1);
    }
}

TEST_CASE("a triangle's count is one number: more rows make a larger triangle") {
    const Analysis found = found_again("axiom: T(7)\nT(m) : m > 0 -> [P(m)] f(7) T(m-1)\n");
    REQUIRE(axiom_symbols(found.grammar) == 1);
    Grammar larger = found.grammar;
    for (ModuleTemplate& module : larger.axiom) {
        if (module.symbol == "Triangle") module.arguments = {number_expression(10)};
    }
    CHECK(interpret(larger).size() == 55);
}
