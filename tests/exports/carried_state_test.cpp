#include "exports/carried_state.h"

#include <catch2/catch.hpp>

#include "lsystem/grammar_text.h"
#include "lsystem/interpret.h"

using namespace rinceau;

namespace {

Grammar grammar_of(const std::string& text) { return parse_grammar("lsystem 1\n" + text); }

std::string written(const Grammar& grammar) { return to_text(grammar).substr(10); }

}  // namespace

TEST_CASE("Scales become arguments, and moves are multiplied") {
    const auto result =
        carried(grammar_of("axiom: *(2) P(3) f(1)\nP(m) : m > 0 -> [A] f(4) *(0.5) P(m-1)\n"), TurtleMemory::scale);
    // P leaves another scale behind, and f needs it
    CHECK_FALSE(result);
    const auto last = carried(grammar_of("axiom: *(2) P(3)\nP(m) : m > 0 -> [A] f(4) *(0.5) P(m-1)\n"), TurtleMemory::scale);
    REQUIRE(last);
    CHECK(written(*last) == "\naxiom: P(3, 2)\n\nP(m, s) : m > 0 -> [A(s)] f(4*s) P(m-1, s*0.5)\n");
}

TEST_CASE("A parameter of the same name keeps its meaning") {
    const auto result = carried(
        grammar_of("define style = 3\naxiom: ;(1) P(2)\nP(s) -> A ;(style) A\nstyle 1: fill red\nstyle 3: fill blue\n"),
        TurtleMemory::style);
    REQUIRE(result);
    CHECK(result->productions.front().parameters == std::vector<std::string>{"s", "style2"});
}

TEST_CASE("Brackets that are opened elsewhere cannot be followed") {
    CHECK_FALSE(carried(grammar_of("axiom: [;(1) P A\nP -> ]\nstyle 1: fill red\n"), TurtleMemory::style));
}
