#include "lsystem/set_numbers.h"

#include <algorithm>
#include <set>

#include <catch2/catch.hpp>

#include "lsystem/check_edit.h"
#include "lsystem/grammar_text.h"
#include "lsystem/interpret.h"
#include "lsystem/numbers.h"
#include "random_grammar.h"

using namespace rinceau;

static Grammar grammar_of(const std::string& body) { return parse_grammar("lsystem 1\n" + body); }

static const GrammarNumber* find(const std::vector<GrammarNumber>& numbers, const std::string& name) {
    const auto found = std::ranges::find(numbers, name, &GrammarNumber::name);
    return found == numbers.end() ? nullptr : &*found;
}

static double value(const Grammar& grammar, const std::string& name) {
    const auto numbers = grammar_numbers(grammar);
    const GrammarNumber* number = find(numbers, name);
    INFO(name);
    REQUIRE(number != nullptr);
    return number->value;
}

static EditResult set(const Grammar& grammar, const std::vector<std::string>& texts, const SetOptions& options = {}) {
    std::vector<NumberEdit> edits;
    for (const std::string& text : texts) edits.push_back(parse_number_edit(text));
    return set_numbers(grammar, edits, options);
}

static std::string production(const Grammar& grammar, int index) {
    Grammar one;
    one.productions = {grammar.productions.at(static_cast<std::size_t>(index))};
    const std::string text = to_text(one);
    return text.substr(text.find("\n\n") + 2);
}

static const std::string leaf = "terminal A: path \"M-1 0H1V-3Z\"\nterminal B: path \"M-1 0H1V-5Z\"\n";
static const std::string ring = "axiom: [Ring(12)] +(55) B\nRing(m) : m > 0 -> [f(50) A] +(30) Ring(m-1)\n" + leaf;

TEST_CASE("numbers are named as a person would say them") {
    const Grammar grammar = grammar_of(
        "define bay = 80\n"
        "axiom: [Row(4)] f(9) Tree(3) +(55) B\n"
        "Row(m) : m > 0 -> [*(0.5) A] -(90) f(bay) +(90) Row(m-1)\n"
        "Tree(m) : m > 0 -> [A] [-(17) f(64) *(0.8) -(3) Tree(m-1)] [f(3) -(90) f(4) +(120) z(2) Tree(m-1)]\n"
        "style 1: stroke black; stroke-width 2; opacity 0.5\n" +
        leaf);
    CHECK(value(grammar, "bay") == 80);
    CHECK(value(grammar, "Row.count") == 4);
    CHECK(value(grammar, "axiom.Row.count") == 4);
    CHECK(value(grammar, "Row.distance") == 80);
    CHECK(value(grammar, "Row.direction") == -90);
    CHECK(value(grammar, "Row.A.scale") == 0.5);
    CHECK(value(grammar, "Tree.levels") == 3);
    CHECK(value(grammar, "Tree.1.turn") == -17);
    CHECK(value(grammar, "Tree.1.distance") == 64);
    CHECK(value(grammar, "Tree.1.scale") == 0.8);
    CHECK(value(grammar, "Tree.1.spin") == -3);
    CHECK(value(grammar, "Tree.2.forward") == 3);
    CHECK(value(grammar, "Tree.2.sideways") == 4);
    CHECK(value(grammar, "Tree.2.rotation") == 30);
    CHECK(value(grammar, "Tree.2.layer") == 2);
    CHECK(value(grammar, "axiom.Tree.distance") == 9);
    CHECK(value(grammar, "axiom.B.turn") == 55);
    CHECK(value(grammar, "style1.stroke_width") == 2);
    CHECK(value(grammar, "style1.opacity") == 0.5);
}

TEST_CASE("a parameter that changes along the way has a start and a change") {
    const Grammar grammar = grammar_of("axiom: P(3)\nP(m) : m > 0 -> [A] +(60+10*m) f(1) -(50-10*m) P(m-1)\n" + leaf);
    CHECK(value(grammar, "P.turn") == 60);
    CHECK(value(grammar, "P.turn_change") == 10);
    CHECK(value(grammar, "P.spin") == -50);
    CHECK(value(grammar, "P.spin_change") == 10);
    CHECK(production(set(grammar, {"P.turn=65", "P.spin_change=-4"}).grammar, 0) ==
          "P(m) : m > 0 -> [A] +(65+10*m) f(1) -(50+4*m) P(m-1)\n");
}

TEST_CASE("a count is what a person counts, whatever the condition") {
    CHECK(value(grammar_of("axiom: P(4)\nP(m) : m > 1 -> A f(1) P(m-1)\n" + leaf), "P.count") == 3);
    CHECK(value(grammar_of("axiom: P(4)\nP(m) : m >= 0 -> A f(1) P(m-1)\n" + leaf), "P.count") == 5);
    CHECK(value(grammar_of("axiom: P(8)\nP(m) : m > 0 -> A f(1) P(m-2)\n" + leaf), "P.count") == 4);
    const Grammar up = grammar_of("axiom: P(2)\nP(i) : i < 7 -> A f(i) P(i+1)\n" + leaf);
    CHECK(value(up, "P.count") == 5);
    for (const int count : {1, 2, 9}) {
        CHECK(interpret(set(up, {"P.count=" + std::to_string(count)}).grammar).size() == static_cast<std::size_t>(count));
    }
}

TEST_CASE("setting a number changes that number only, and no name") {
    const Grammar grammar = grammar_of(
        "# kept\ndefine n = 5\naxiom: [Row(4)] f(9) Grid(n) +(55) B\n"
        "# a row\nRow(m) : m > 0 -> [*(0.5) A] -(90) f(13) +(90) Row(m-1)\n"
        "Grid(m) : m > 0 -> [Row(3)] f(51) Grid(m-1)\n"
        "# moved\nexcept 1.2 -> f(3) A\nstyle 1: fill none; stroke red\n" +
        leaf);
    const auto numbers = grammar_numbers(grammar);
    for (const GrammarNumber& number : numbers) {
        if (!number.parts.empty()) continue;
        INFO(number.name);
        const double wanted = number.kind == NumberKind::share ? 0.25 : number.value + 1;
        const EditResult edit = set(grammar, {number.name + "=" + std::to_string(wanted)}, {.keep_rings_closed = false});
        CHECK(value(edit.grammar, number.name) == Approx(wanted));
        const auto after = grammar_numbers(edit.grammar);
        REQUIRE(after.size() == numbers.size());
        for (std::size_t i = 0; i < after.size(); ++i) CHECK(after[i].name == numbers[i].name);
        // and back: nothing else is different
        const EditResult back =
            set(edit.grammar, {number.name + "=" + std::to_string(number.value)}, {.keep_rings_closed = false});
        Grammar same = back.grammar;
        same.seed = grammar.seed;
        CHECK(to_text(same) == to_text(grammar));
    }
}

TEST_CASE("other productions rename nothing") {
    const std::string rules = "Row(m) : m > 0 -> [*(0.5) A] f(13) Row(m-1)\n" + leaf;
    const auto before = grammar_numbers(grammar_of("axiom: [Row(4)] +(5) B\n" + rules));
    const auto after =
        grammar_numbers(grammar_of("axiom: [Row(4)] +(5) B Col(3)\nCol(m) : m > 0 -> [A] f(5) Col(m-1)\n" + rules));
    for (const GrammarNumber& number : before) {
        INFO(number.name);
        CHECK(find(after, number.name) != nullptr);
    }
}

TEST_CASE("names of random grammars are unique") {
    for (unsigned seed = 1; seed <= 60; ++seed) {
        Random random(seed);
        const Grammar grammar = random_grammar(random);
        std::set<std::string> names;
        for (const GrammarNumber& number : grammar_numbers(grammar)) {
            INFO(seed << ' ' << number.name);
            CHECK(names.insert(number.name).second);
        }
    }
}

TEST_CASE("a ring stays closed when its count is set") {
    const EditResult edit = set(grammar_of(ring), {"Ring.count=10"});
    CHECK(value(edit.grammar, "Ring.count") == 10);
    CHECK(value(edit.grammar, "Ring.turn") == 36);
    CHECK(edit.changes == std::vector<std::string>{"Ring.count 12 -> 10", "Ring.turn 30 -> 36 so that the ring is closed"});
    CHECK(production(set(grammar_of(ring), {"Ring.count=7"}).grammar, 0) ==
          "Ring(m) : m > 0 -> [f(50) A] +(360/7) Ring(m-1)\n");
    CHECK(value(set(grammar_of(ring), {"Ring.count=10"}, {.keep_rings_closed = false}).grammar, "Ring.turn") == 30);
}

TEST_CASE("a ring gets the count that its turn closes") {
    CHECK(value(set(grammar_of(ring), {"Ring.turn=45"}).grammar, "Ring.count") == 8);
    CHECK(value(set(grammar_of(ring), {"Ring.turn=60"}).grammar, "Ring.count") == 6);
    CHECK_THROWS_AS(set(grammar_of(ring), {"Ring.turn=50"}), InputError);
    CHECK(value(set(grammar_of(ring), {"Ring.turn=50"}, {.keep_rings_closed = false}).grammar, "Ring.count") == 12);
}

TEST_CASE("a ring stays closed however its count and turn are written") {
    const std::vector<std::string> bodies{
        "define n = 12\naxiom: Ring(n)\nRing(m) : m > 0 -> [f(50) A] +(360/n) Ring(m-1)\n",
        "define n = 12\naxiom: Ring(n)\nRing(m) : m > 0 -> [f(50) A] -(30) Ring(m-1)\n",
        "define n = 12\ndefine t = 360/n\naxiom: Ring(n)\nRing(m) : m > 0 -> [f(50) A] +(t) Ring(m-1)\n",
        "define t = 30\naxiom: Ring(12)\nRing(m) : m > 0 -> [f(50) A] +(t) Ring(m-1)\n",
        "axiom: Ring(12, 12)\nRing(m, n) : m > 0 -> [f(50) A] +(360/n) Ring(m-1, n)\n",
        "axiom: Ring(12, 30)\nRing(m, a) : m > 0 -> [f(50) A] +(a) Ring(m-1, a)\n",
        "axiom: Ring(11)\nRing(m) : m > 0 -> [f(50) A] +(30) Ring(m-1)\nRing(m) : m == 0 -> f(50) A\n",
        "axiom: Ring(12)\nRing(m) : m > 0 -> [A] +(90) f(10) -(60) Ring(m-1)\n",
        "axiom: Ring(12)\nRing(m) : m > 0 -> [f(50) A] +(30+normal(0, 2)) Ring(m-1)\n",
        "axiom: Ring(12)\nRing(m) : m > 0 -> [f(9) B] [| f(9) B] [f(50) A] +(30) Ring(m-1)\n",
        "axiom: [Wreath(6)]\nWreath(m) : m > 0 -> [f(90) Ring(12)] +(60) Wreath(m-1)\n"
        "Ring(m) : m > 0 -> [f(50) A] +(30) Ring(m-1)\n",
    };
    for (const std::string& body : bodies) {
        for (const std::string count : {"5", "7", "24"}) {
            INFO(body << count);
            const Grammar grammar = grammar_of(body + leaf);
            const Grammar after = set(grammar, {"Ring.count=" + count}).grammar;
            // The turtle is back at its heading: a marker at the end stands as one at the beginning.
            const auto heading = [](Grammar probe) {
                probe.terminals.push_back({.symbol = "Ring", .style = 0, .paths = probe.terminals.front().paths});
                std::vector<Complex> headings;
                for (const Placement& placement : interpret(probe))
                    if (probe.terminals[static_cast<std::size_t>(placement.terminal)].symbol == "Ring")
                        headings.push_back(placement.pose.linear);
                return headings;
            };
            if (body.find("normal") != std::string::npos || body.find("m == 0") != std::string::npos) continue;
            const auto first = heading(grammar);
            const auto second = heading(after);
            REQUIRE(first.size() == second.size());
            for (std::size_t i = 0; i < first.size(); ++i) CHECK(abs(first[i] - second[i]) < 1e-9);
        }
    }
    CHECK(value(set(grammar_of(bodies[8] + leaf), {"Ring.count=9"}).grammar, "Ring.turn") == 40);
    CHECK(value(set(grammar_of(bodies[6] + leaf), {"Ring.count=8"}).grammar, "Ring.turn") == 40);
}

TEST_CASE("a golden angle is no ring") {
    const Grammar flower =
        grammar_of("axiom: P(144)\nP(m) : m > 0 -> [f(4*sqrt(m)) A] +(137.5) P(m-1)\n" + leaf);  // 144 * 137.5 = 55 * 360
    CHECK(value(set(flower, {"P.count=100"}).grammar, "P.turn") == 137.5);
}

TEST_CASE("a count that rules share is set once and says what goes with it") {
    const Grammar grammar = grammar_of(
        "define n = 12\naxiom: [Ring(n)] [Row(n)]\nRing(m) : m > 0 -> [f(50) A] +(360/n) Ring(m-1)\n"
        "Row(m) : m > 0 -> [B] f(9) Row(m-1)\n" +
        leaf);
    const EditResult edit = set(grammar, {"Ring.count=8"});
    CHECK(value(edit.grammar, "n") == 8);
    CHECK(value(edit.grammar, "Row.count") == 8);
    REQUIRE(edit.changes.size() == 2);
    CHECK(edit.changes[0] == "Ring.count 12 -> 8 (n)");
    CHECK(edit.changes[1] == "with it: Row.count 12 -> 8, Ring.turn 30 -> 45");
}

TEST_CASE("edits are absolute, relative or expressions, in order") {
    const Grammar grammar =
        grammar_of("define bay = 80\naxiom: Row(4)\nRow(m) : m > 0 -> [A] f(bay) +(5) Row(m-1)\n" + leaf);
    CHECK(value(set(grammar, {"bay=80*1.5"}).grammar, "bay") == 120);
    CHECK(value(set(grammar, {"bay*=1.5", "bay-=20"}).grammar, "bay") == 100);
    CHECK(value(set(grammar, {"bay=150%", "Row.count+=2"}).grammar, "Row.count") == 6);
    CHECK(value(set(grammar, {"Row.spin=-bay/2"}).grammar, "Row.spin") == -40);
    CHECK(value(set(grammar, {"Row.spin=-12"}).grammar, "Row.spin") == -12);
    CHECK(production(set(grammar, {"Row.spin=-12"}).grammar, 0) == "Row(m) : m > 0 -> [A] f(bay) -(12) Row(m-1)\n");
    CHECK(value(set(grammar, {"bay/=0.1*5"}).grammar, "Row.distance") == 160);
    for (const std::string wrong :
         {"Row.cuont=3", "Row.count=2.5", "Row.count=-1", "bay=1/0", "bay=", "=3", "bay", "bay=x", "bay=bay"}) {
        INFO(wrong);
        CHECK_THROWS_AS(checked_edit(grammar, set(grammar, {wrong})), InputError);
    }
}

TEST_CASE("a name with a star sets all numbers that fit") {
    const Grammar edited =
        set(grammar_of(
                "axiom: [A1(4)] B1(4)\nA1(m) : m > 0 -> [A] +(10) f(3) A1(m-1)\nB1(m) : m > 0 -> [B] +(20) f(3) B1(m-1)\n" +
                leaf),
            {"*.turn*=2"})
            .grammar;
    CHECK(value(edited, "A1.turn") == 20);
    CHECK(value(edited, "B1.turn") == 40);
}

TEST_CASE("direction turns the way, rotation what stands at its end") {
    const Grammar grammar = grammar_of("axiom: Row(4)\nRow(m) : m > 0 -> [A] -(90) f(10) +(90) Row(m-1)\n" + leaf);
    const Grammar tilted = set(grammar, {"Row.direction=-60"}).grammar;
    const auto placed = interpret(tilted);
    CHECK(abs(placed.back().pose.linear - Complex{1, 0}) < 1e-12);
    CHECK(placed.back().pose.translation.x == Approx(30 * std::sin(pi / 3)));
    CHECK(production(set(grammar, {"Row.rotation=5"}).grammar, 0) == "Row(m) : m > 0 -> [A] -(90) f(10) +(95) Row(m-1)\n");
}

TEST_CASE("exceptions whose place is gone are dropped, and it is said") {
    const Grammar grammar = grammar_of(
        "axiom: Row(6)\nRow(m) : m > 0 -> [A] f(10) Row(m-1)\n"
        "except 1.2 -> B\nexcept 1.5 -> B\nexcept 1.6 ->\nexcept 7.7 -> B\n" +
        leaf);
    const EditResult edit = checked_edit(grammar, set(grammar, {"Row.count=4"}));
    REQUIRE(edit.grammar.exceptions.size() == 2);
    CHECK(edit.grammar.exceptions[0].address == std::vector<int>{1, 2});
    CHECK(edit.grammar.exceptions[1].address == std::vector<int>{7, 7});  // was of no use before, either
    CHECK(edit.changes == std::vector<std::string>{"Row.count 6 -> 4",
                                                   "2 exceptions dropped (1.5, 1.6): nothing stands there now",
                                                   "5 -> 4 elements"});
    CHECK_THROWS_AS(checked_edit(grammar, set(grammar, {"Row.count=0"})), InputError);
}
