#include "exports/houdini.h"

#include <catch2/catch.hpp>

#include "lsystem/grammar_text.h"

using namespace rinceau;
using Catch::Matchers::Contains;

namespace {

Export houdini_of(const std::string& text) { return to_houdini(parse_grammar("lsystem 1\n" + text)); }

const std::string stroke = "style 1: fill none; stroke #ff0000\nterminal A: style 1; path \"M0 0V-10\"\n";

}  // namespace

TEST_CASE("Houdini gets the scale as an argument, and turns the other way") {
    const std::string text =
        houdini_of("axiom: P(336)\nP(m) : m > 0 -> [A] f(27.5) *(0.993) +(8.5) P(m-1)\n" + stroke).bytes;
    CHECK_THAT(text, Contains("Generations: 337\nPremise: P(336,1)\n"));
    CHECK_THAT(text, Contains("P(m,n):m>0=[A(n)]f(27.5*n)-(8.5)P(m-1,n*0.993)\n"));
    CHECK_THAT(text, Contains("A(m)=[a(\"Cd\",1,0,0)F(10*m,1*m)]\n"));
}

TEST_CASE("Houdini's rules exclude each other, and no condition has a sign =") {
    const std::string text =
        houdini_of("axiom: P(3)\nP(m) : m >= 2 -> A P(m-1)\nP(m) : m == 1 && m != 7 -> A\nP(k) -> f(k)\n" + stroke).bytes;
    CHECK_THAT(text, Contains("P(m):!(m<2)=AP(m-1)\n"));
    CHECK_THAT(text, Contains("P(m):(!(!(m<2)))&((!((m<1)|(m>1)))&((m<7)|(m>7)))=A\n"));
    CHECK_THAT(text, Contains("P(m):(!(!(m<2)))&(!((!((m<1)|(m>1)))&((m<7)|(m>7))))=f(m)\n"));
}

TEST_CASE("What Houdini has no counterpart of is written out, and the note says what it is") {
    const Export result = houdini_of("axiom: P(3)\nP(m) : m > 0 -> [+(sin(m)) A] P(m-1)\n" + stroke);
    REQUIRE_FALSE(result.notes.empty());
    CHECK(result.notes.front() ==
          "The rules are not kept, every element is placed by itself: Houdini has no counterpart of sin(m).");
}

TEST_CASE("A command without its argument is refused") {
    CHECK_THROWS_WITH(houdini_of("axiom: P(3)\nP(m) : m > 0 -> A * P(m-1)\n" + stroke), Contains("expected 1 argument"));
}
