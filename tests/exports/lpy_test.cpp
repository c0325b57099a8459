#include "exports/lpy.h"

#include <catch2/catch.hpp>

#include "lsystem/grammar_text.h"

using namespace rinceau;
using Catch::Matchers::Contains;

namespace {

std::string lpy_of(const std::string& text) { return to_lpy(parse_grammar("lsystem 1\n" + text)).bytes; }

}  // namespace

TEST_CASE("L-Py gets the rules of a symbol as one rule with all conditions") {
    const std::string text = lpy_of(
        "axiom: P(3)\n"
        "P(m) : m > 0 && m != 7 -> [A] f(27.5) *(0.993) +(8.5) P(m-1)\n"
        "P(k) : k == 0 -> B\n"
        "terminal A: path \"M0 0L1 1\"\n");
    CHECK_THAT(text, Contains("P(m):\n"
                              "    if ((m > 0) != 0) and ((m != 7) != 0):\n"
                              "        produce [ A ] f(27.5) @Di(0.993) +(8.5) P(m-1)\n"
                              "    elif m == 0:\n"
                              "        produce B\n"));
}

TEST_CASE("L-Py's own words are no symbols and Python's are no parameters") {
    const std::string text = lpy_of(
        "define lambda = 2\n"
        "axiom: Box(lambda) F\n"
        "Box(in) -> Circle f(in)\n"
        "terminal Circle: path \"M0 0L1 1\"\n");
    CHECK_THAT(text, Contains("lambda_ = 2\n"));
    CHECK_THAT(text, Contains("module Box_, Circle_, F_\n"));
    CHECK_THAT(text, Contains("Axiom: Box_(lambda_) F_\n"));
    CHECK_THAT(text, Contains("Box_(in_):\n    produce Circle_ f(in_)\n"));
    CHECK_THAT(text, Contains("#   Box is Box_\n"));
}

TEST_CASE("L-Py mirrors by a roll and erases by a module that does nothing") {
    CHECK_THAT(lpy_of("axiom: | A(1)\nA(m) ->\n"),
               Contains("Axiom: /(180) A(1)\n") && Contains("A(m):\n    produce f(0)\n"));
}

TEST_CASE("A style by number is an argument in L-Py") {
    const std::string text = lpy_of(
        "axiom: ;(2) A [;(0) P] A\n"
        "P -> A ;(1)\n"
        "style 1: fill #010203\nstyle 2: fill #040506\n"
        "terminal A: style 1; path \"M0 0H2V2Z\"\n");
    CHECK_THAT(text, Contains("Axiom: A(2) [ P(0) ] A(2)\n"));
    CHECK_THAT(text, Contains("P(style):\n    produce A(style)\n"));
    CHECK_THAT(text, Contains("    elif style == 2:\n        produce SetColor(4, 5, 6)"));
}

TEST_CASE("Where a style is left behind for what follows, L-Py gets the placements") {
    const Export result = to_lpy(
        parse_grammar("lsystem 1\naxiom: P A\nP -> ;(1) f(2)\nstyle 1: fill #010203\nterminal A: path \"M0 0H2V2Z\"\n"));
    CHECK_THAT(result.bytes, Contains("Axiom: [ f(2) A(1) ]\n"));
    REQUIRE(result.notes.size() == 1);
    CHECK_THAT(result.notes.front(), Contains("The rules are not kept"));
}
