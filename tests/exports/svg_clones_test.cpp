#include "exports/svg_clones.h"

#include <catch2/catch.hpp>

#include "lsystem/grammar_text.h"

using namespace rinceau;

static Export exported(const std::string& body) {
    return to_svg_clones(parse_grammar("lsystem 1\n" + body + "\nterminal A: path \"M0 0H1V-2Z\"\n"));
}

static int count(const std::string& text, const std::string& part) {
    int found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
}

TEST_CASE("the first of several is an element, the others are clones of it") {
    const std::string svg = exported("axiom: P(3)\nP(m) : m > 0 -> [A] f(5) P(m-1)").bytes;
    CHECK(count(svg, "<path id=\"A\"") == 1);
    CHECK(count(svg, "<use xlink:href=\"#A\"") == 2);
    CHECK(svg.find("<path") < svg.find("<use"));
    CHECK(svg.find("<defs>") == std::string::npos);
}

TEST_CASE("groups are nested as the rules are, and equal groups are clones") {
    const std::string svg =
        exported(
            "axiom: Grid(2)\nGrid(m) : m > 0 -> [Row(4)] f(9) Grid(m-1)\nRow(m) : m > 0 -> [A] -(90) f(3) +(90) Row(m-1)")
            .bytes;
    CHECK(count(svg, "inkscape:label=\"Grid\"") == 1);
    CHECK(count(svg, "inkscape:label=\"Row\"") == 1);
    CHECK(count(svg, "<use xlink:href=\"#Row\" transform=\"translate(0 -9)\"/>") == 1);
    CHECK(count(svg, "<use xlink:href=\"#A\"") == 3);
}

TEST_CASE("what is drawn once has its place itself") {
    const std::string svg = exported("axiom: f(5) A").bytes;
    CHECK(svg.find("<path id=\"A\" transform=\"translate(0 -5)\"") != std::string::npos);
    CHECK(count(svg, "<use") == 0);
}

TEST_CASE("strokes of fixed width keep it in every clone") {
    const Export result = exported("axiom: [;(1) A] [*(2) ;(1) A]\nstyle 1: fill none; stroke red; stroke-width 3 fixed");
    CHECK(result.bytes.find("stroke-width=\"1.5\"") != std::string::npos);
    CHECK(result.notes.size() == 1);
}

TEST_CASE("ids in fragments are not given again") {
    const std::string svg = exported("axiom: V A A\nterminal V: verbatim <<<SVG\n<text id=\"A\">x</text>\nSVG\n").bytes;
    CHECK(count(svg, "id=\"A\"") == 1);
    CHECK(count(svg, "id=\"A_\"") == 1);
}
