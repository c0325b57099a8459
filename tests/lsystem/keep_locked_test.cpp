#include "lsystem/keep_locked.h"

#include <algorithm>

#include <catch2/catch.hpp>

#include "lsystem/grammar_text.h"
#include "lsystem/numbers.h"
#include "lsystem/randomize.h"
#include "lsystem/set_numbers.h"
#include "lsystem/symmetrize.h"

using namespace rinceau;

namespace {

Grammar grammar_of(const std::string& body) {
    return parse_grammar("lsystem 1\n" + body + "terminal A: path \"M-1 0H1V-3Z\"\nterminal B: path \"M-1 0H1V-5Z\"\n");
}

Grammar ring() { return grammar_of("axiom: [Ring(12)] +(55) B\nRing(m) : m > 0 -> [f(50) A] +(30) Ring(m-1)\n"); }

EditResult set(const Grammar& grammar, const std::string& text) {
    const NumberEdit edit = parse_number_edit(text);
    return set_numbers(grammar, {&edit, 1});
}

double value(const Grammar& grammar, const std::string& name) {
    const auto numbers = grammar_numbers(grammar);
    const auto found = std::ranges::find(numbers, name, &GrammarNumber::name);
    REQUIRE(found != numbers.end());
    return found->value;
}

}  // namespace

TEST_CASE("a locked number cannot be set, others can") {
    const Grammar before = ring();
    CHECK_THROWS_WITH(keep_locked(before, set(before, "axiom.B.turn=60"), {"axiom.B.turn"}),
                      Catch::Contains("axiom.B.turn is locked"));
    CHECK(value(keep_locked(before, set(before, "axiom.B.turn=60"), {"Ring.count"}).grammar, "axiom.B.turn") == 60);
    CHECK(to_text(keep_locked(before, {before, {}}, {"Ring.count"}).grammar) == to_text(before));
}

TEST_CASE("a ring whose turn is locked keeps its count, and the other way round") {
    const Grammar before = ring();
    CHECK_THROWS_AS(keep_locked(before, set(before, "Ring.count=10"), {"Ring.turn"}), InputError);
    CHECK_THROWS_AS(keep_locked(before, set(before, "Ring.turn=36"), {"Ring.count"}), InputError);
    const Grammar both = keep_locked(before, set(before, "Ring.*=12"), {"Ring.count", "Ring.turn"}).grammar;
    CHECK(value(both, "Ring.count") == 12);
    CHECK(value(both, "Ring.turn") == 30);
    CHECK(value(both, "Ring.A.distance") == 12);
}

TEST_CASE("what is written with a locked constant stays as well") {
    const Grammar before =
        grammar_of("define bay = 80\naxiom: Row(4) B\nRow(m) : m > 0 -> [A] -(90) f(bay) +(90) Row(m-1)\n");
    CHECK_THROWS_AS(keep_locked(before, set(before, "Row.distance=90"), {"bay"}), InputError);
    CHECK_THROWS_AS(keep_locked(before, set(before, "bay=90"), {"Row.distance"}), InputError);
    const std::string text = to_text(keep_locked(before, set(before, "*=7"), {"bay"}).grammar);
    CHECK(text.find("define bay = 80") != std::string::npos);
    CHECK(text.find("f(bay)") != std::string::npos);
}

TEST_CASE("randomizing puts no noise on a locked number") {
    const Grammar before = grammar_of("axiom: Hand(5)\nHand(m) : m > 0 -> [A] +(8) f(20) Hand(m-1)\n");
    const EditResult wild =
        randomize(before, {.angle = 5, .distance = 0.1, .only = {"Hand.turn", "Hand.distance"}, .seed = 3});
    REQUIRE(to_text(wild.grammar).find("f(20*(1+normal(0, 0.1)))") != std::string::npos);
    const EditResult kept = keep_locked(before, wild, {"Hand.distance"});
    CHECK(to_text(kept.grammar).find("f(20) ") != std::string::npos);
    CHECK(to_text(kept.grammar).find("+(8+normal(0, 5))") != std::string::npos);
    CHECK(kept.changes.back() == "Hand.distance is locked and left as before");
}

TEST_CASE("symmetrizing leaves a locked number as it is") {
    const Grammar before = grammar_of(
        "axiom: [R(7)] [S(5)]\nR(m) : m > 0 -> [f(50) A] +(51) R(m-1)\n"
        "S(m) : m > 0 -> [f(30) B] +(71) S(m-1)\n");
    const Grammar after = keep_locked(before, symmetrize(before), {"R.turn"}).grammar;
    CHECK(value(after, "R.turn") == 51);
    CHECK(value(after, "S.turn") == 72);
}

TEST_CASE("numbers that an edit takes away do not hold it up") {
    const Grammar before = ring();
    const Grammar other = grammar_of("axiom: B\n");
    CHECK(to_text(keep_locked(before, {other, {}}, {"Ring.count", "axiom.B.turn"}).grammar) == to_text(other));
}
