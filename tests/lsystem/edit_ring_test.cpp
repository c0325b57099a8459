#include "lsystem/edit_ring.h"

#include <cmath>

#include <catch2/catch.hpp>

#include "geometry/angle.h"
#include "lsystem/grammar_text.h"
#include "lsystem/interpret.h"
#include "lsystem/ring.h"

using namespace rinceau;

namespace {

const std::string leaf = "terminal A: path \"M-1 0H1V-3Z\"\nterminal B: path \"M-1 0H1V-5Z\"\n";

Grammar grammar_of(const std::string& body) { return parse_grammar("lsystem 1\n" + body + leaf); }

Grammar row(const std::string& end = "") {
    return grammar_of("axiom: f(7) Row(5) B\nRow(m) : m > 0 -> [A] -(90) f(20) +(90) Row(m-1)\n" + end);
}

std::vector<Point> places(const Grammar& grammar, const std::string& terminal) {
    std::vector<Point> result;
    for (const Placement& placement : interpret(grammar))
        if (grammar.terminals[static_cast<std::size_t>(placement.terminal)].symbol == terminal)
            result.push_back(placement.pose.translation);
    return result;
}

}  // namespace

TEST_CASE("a row becomes a closed ring about its middle") {
    const Grammar ring = make_ring(row(), "Row", {.radius = 30}).grammar;
    CHECK(closed_rings(ring).size() == 1);
    const std::vector<Point> rim = places(ring, "A");
    REQUIRE(rim.size() == 5);
    const Point middle{40, 7};  // of places 0, 20, .. 80 at height 7
    for (const Point& place : rim) CHECK(abs(place - middle) == Approx(30).margin(1e-4));
    CHECK(abs(rim[1] - rim[0]) == Approx(abs(rim[0] - rim[4])).margin(1e-4));
    CHECK(abs(places(ring, "B").front() - Point{0, 7}) == Approx(0).margin(1e-9));  // the turtle is where the row began
}

TEST_CASE("without a radius neighbours stay as far apart as they are, in the ring and in the row again") {
    const Grammar ring = make_ring(row(), "Row").grammar;
    const std::vector<Point> rim = places(ring, "A");
    CHECK(abs(rim[1] - rim[0]) == Approx(20).margin(1e-3));
    const std::vector<Point> again = places(make_row(ring, "Row").grammar, "A");
    const std::vector<Point> first = places(row(), "A");
    REQUIRE(again.size() == first.size());
    for (std::size_t i = 0; i < first.size(); ++i) CHECK(abs(again[i] - first[i]) == Approx(0).margin(1e-2));
}

TEST_CASE("the last element of a rule with an end stands on the rim, too") {
    const Grammar ring = make_ring(row("Row(m) : m <= 0 -> A\n"), "Row", {.radius = 10}).grammar;
    const std::vector<Point> rim = places(ring, "A");
    REQUIRE(rim.size() == 6);
    Point sum{};
    for (const Point& place : rim) sum += place;
    for (const Point& place : rim) CHECK(abs(place - sum / 6) == Approx(10).margin(1e-4));
}

TEST_CASE("what cannot be a ring is refused") {
    CHECK_THROWS_AS(make_ring(row(), "A"), InputError);
    const Grammar two = grammar_of("axiom: Row(5) Row(6)\nRow(m) : m > 0 -> [A] f(20) Row(m-1)\n");
    CHECK_THROWS_WITH(make_ring(two, "Row"), Catch::Contains("same count"));
    const Grammar tree = grammar_of("axiom: R(3)\nR(m) : m > 0 -> A [+(20) f(9) R(m-1)] [-(20) f(9) R(m-1)]\n");
    CHECK_THROWS_WITH(make_ring(tree, "R"), Catch::Contains("branches"));
    CHECK_THROWS_WITH(make_row(row(), "Row"), Catch::Contains("turn"));
    CHECK(symbols_of_rows(tree).empty());
    CHECK(symbols_of_rows(row()) == std::vector<std::string>{"Row"});
}
