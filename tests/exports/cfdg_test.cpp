#include "exports/cfdg.h"

#include <catch2/catch.hpp>

#include "lsystem/grammar_text.h"

using namespace rinceau;

static Export exported(const std::string& body, const ExportOptions& options = {}) {
    return to_cfdg(parse_grammar("lsystem 1\n" + body + "\nterminal A: path \"M0 0H1V-2Z\"\n"), options);
}

static bool has(const Export& result, const std::string& text) {
    INFO(result.bytes);
    return result.bytes.find(text) != std::string::npos;
}

TEST_CASE("a sequence is a shape with a natural parameter") {
    const Export result = exported("axiom: P(336)\nP(m) : m > 0 -> [A] f(27.5) *(0.993) +(8.5) P(m-1)");
    CHECK(has(result,
              "shape P(natural m) {\n  if (m > 0) {\n    A []\n    P(m -- 1) [[ y 27.5 s 0.993 r 8.5 z 1 ]]\n  }\n}\n"));
    CHECK(result.notes.empty());
}

TEST_CASE("several productions are one chain of choices, and a symbol may be drawn where none applies") {
    const Export result = exported("axiom: A(3)\nA(m) : m > 2 -> [f(1) A(m-1)]\nA(m) : m > 1 -> [f(2) A(m-2)]");
    CHECK(has(result, "  if (m > 2) {\n"));
    CHECK(has(result, "  else if (m > 1) {\n"));
    CHECK(has(result, "  else { A_ [] }\n"));
}

TEST_CASE("numbers that are not whole go through functions at the end of the file") {
    const Export result = exported("define step = 1.5\naxiom: P(7.5)\nP(m) : m > 0 -> [A] f(m) P(m - step)");
    CHECK(has(result, "shape P(number m)"));
    CHECK(has(result, "P(P_m(m)) [[ y (m) z 1 ]]"));
    const std::size_t function = result.bytes.find("\nP_m(number m) = m - step\n");
    REQUIRE(function != std::string::npos);
    CHECK(function > result.bytes.find("path A"));
}

TEST_CASE("rules that only move are written out, rules that draw and move are followed by numbers") {
    const Export result =
        exported("axiom: Right(3) Row(4) A\nRight(d) -> -(90) f(d) +(90)\nRow(m) : m > 0 -> [A] Right(5) Row(m-1)");
    CHECK(has(result, "Row(4) [[ r -90 y 3 r 90 ]]"));
    CHECK(has(result, "A [[ r -90 y 3 r 90 x 20 z 4 ]]"));
    CHECK(has(result, "Row(m -- 1) [[ r -90 y 5 r 90 z 1 ]]"));
}

TEST_CASE("a rule whose move depends on its parameter is written part by part") {
    const Export result = exported("axiom: F(3)\nF(n) : n > 0 -> F(n-1) +(60) F(n-1)\nF(n) : n == 0 -> A f(1)");
    CHECK_FALSE(has(result, "natural"));
    REQUIRE(result.notes.size() == 1);
    CHECK(result.notes[0].find("with numbers") != std::string::npos);
}

TEST_CASE("words of Context Free are no names in the file") {
    const Export result = exported("define hue = 2\naxiom: MOVETO(3)\nMOVETO(x) : x > 0 -> A f(hue) MOVETO(x-1)");
    CHECK(has(result, "hue_ = 2"));
    CHECK(has(result, "shape MOVETO_(natural x_)"));
}

TEST_CASE("a colour is reached from black") {
    const Export result = exported("axiom: [;(1) A]\nstyle 1: fill #0000ff; fill-opacity 0.5; stroke white; stroke-width 2");
    CHECK(has(result, "FILL[h 240 sat 1 b 1 a -0.5]"));
    CHECK(has(result, "STROKE(2)[b 1]"));
}

TEST_CASE("what Context Free cannot hold is said") {
    const Export result = exported(
        "axiom: ;(1) A\nstyle 1: fill linear-gradient(matrix(1 0 0 1 0 0), 0 black, 1 white); stroke red; stroke-dasharray "
        "1 2");
    REQUIRE(result.notes.size() == 2);
    CHECK(result.notes[0].find("gradients") != std::string::npos);
    CHECK(result.notes[1].find("dashes") != std::string::npos);
    CHECK(has(result, "FILL[b 0.5019607843137255]"));
}

TEST_CASE("a canvas becomes the size of the picture") {
    CHECK(has(exported("canvas 10 20 300 100\naxiom: A"), "CF::Size = [s 300 100 x -160 y 70]"));
    CHECK_FALSE(has(exported("axiom: A"), "CF::Size"));
}
