#include "exports/cpfg.h"

#include <catch2/catch.hpp>

#include "lsystem/grammar_text.h"

using namespace rinceau;
using Catch::Matchers::Contains;

namespace {

Export cpfg_of(const std::string& text) { return to_cpfg(parse_grammar("lsystem 1\n" + text)); }

}  // namespace

TEST_CASE("cpfg gets the rules as a decomposition, so that counts do not matter") {
    const std::string text = cpfg_of(
                                 "axiom: P(336)\n"
                                 "P(m) : m > 0 -> [A] f(27.5) *(0.993) +(8.5) P(m-1)\n"
                                 "P(m) : m == 0 -> \n"
                                 "style 1: fill none; stroke #228b22; stroke-width 2\n"
                                 "terminal A: style 1; path \"M0 0V-10\"\n")
                                 .bytes;
    CHECK_THAT(text, Contains("axiom: P(336)\n\ndecomposition\nmaximum depth: 100000\n"
                              "P(m) : m > 0 --> [A]f(27.5)@Di(0.993)+(8.5)P(m-1)\n"
                              "P(m) : m == 0 --> *\n"
                              "homomorphism\n"
                              "A --> [;(1)#(2)F(10)]\n"
                              "endlsystem\n"));
}

TEST_CASE("cpfg's symbols are single characters that its turtle does not know") {
    const std::string text = cpfg_of("axiom: Flower Fence D i Flower\nterminal D: path \"M0 0H1V1Z\"\n").bytes;
    CHECK_THAT(text, Contains("axiom: "));
    for (const char* const taken : {"axiom: F", "/* F is", "D is", "i is i"})
        CHECK_THAT(text, !Contains(std::string("/*   ") + taken));
}

TEST_CASE("More symbols than characters share the last one") {
    std::string axiom = "axiom:";
    std::string terminals;
    for (int k = 0; k < 60; ++k) {
        axiom += " T" + std::to_string(k);
        terminals += "terminal T" + std::to_string(k) + ": path \"M0 0H" + std::to_string(k + 1) + "V1Z\"\n";
    }
    const std::string text = cpfg_of(axiom + "\n" + terminals).bytes;
    CHECK_THAT(text, Contains("z(14)"));
    CHECK_THAT(text, Contains("z(k_which0) : k_which0 == 14 --> "));
}

TEST_CASE("cpfg's colour map has the background and the colours in use") {
    const Export result = cpfg_of("axiom: A\nstyle 1: fill #0a0b0c\nterminal A: style 1; path \"M0 0H2V2Z\"\n");
    REQUIRE(result.companions.size() == 2);
    CHECK(result.companions[0].ending == ".v");
    REQUIRE(result.companions[1].ending == ".map");
    REQUIRE(result.companions[1].bytes.size() == 768);
    CHECK(result.companions[1].bytes.substr(0, 6) == "\xff\xff\xff\x0a\x0b\x0c");
}

TEST_CASE("cpfg's exponents have a point, and what it lacks is written with what it has") {
    const std::string text = cpfg_of("axiom: A(0.00000001) A(min(3, 2)) A(7 % 3)\nA(x) -> f(x)\n").bytes;
    CHECK_THAT(text, Contains("A(1.0e-08)A(((3)<(2))?(3):(2))A(7-3*floor(7/3))"));
}
