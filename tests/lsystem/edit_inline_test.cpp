#include "lsystem/edit_inline.h"

#include <catch2/catch.hpp>

#include "lsystem/edit_group.h"
#include "lsystem/grammar_text.h"
#include "lsystem/interpret.h"

using namespace rinceau;

namespace {

const std::string facade =
    "lsystem 1\ndefine bay = 20\naxiom: f(3) Wall(4) Door(2)\nWall(m) : m > 0 -> [Row(5, m)] f(30) Wall(m-1)\n"
    "Row(n, k) : n > 0 -> [Window(k)] -(90) f(bay) +(90) Row(n-1, k)\nWindow(k) -> [A] [f(2*k) ;(1) B] +(k) A\n"
    "Door(w) -> f(w) B [A]\nstyle 1: fill #ff0000\nterminal A: path \"M-1 0H1V-3Z\"\nterminal B: path \"M-1 0H1V-5Z\"\n";

void check_same_picture(const Grammar& a, const Grammar& b) {
    const std::vector<Placement> first = interpret(a);
    const std::vector<Placement> second = interpret(b);
    REQUIRE(first.size() == second.size());
    constexpr double rounding = 1e-9;
    for (std::size_t i = 0; i < first.size(); ++i) {
        CHECK(first[i].terminal == second[i].terminal);
        CHECK(first[i].style == second[i].style);
        CHECK(abs(first[i].pose.translation - second[i].pose.translation) < rounding);
        CHECK(abs(first[i].pose.linear - second[i].pose.linear) < rounding);
    }
}

}  // namespace

TEST_CASE("a rule in the place of its symbol draws the same picture") {
    const Grammar grammar = parse_grammar(facade);
    CHECK(symbols_to_inline(grammar) == std::vector<std::string>{"Window", "Door"});
    for (const std::string& symbol : symbols_to_inline(grammar)) {
        const Grammar inlined = inline_rule(grammar, symbol).grammar;
        CHECK(inlined.productions.size() + 1 == grammar.productions.size());
        check_same_picture(grammar, inlined);
        check_same_picture(grammar, parse_grammar(to_text(inlined)));
    }
}

TEST_CASE("exceptions move along when a rule is put in the place of its symbol") {
    // the second terminal of a window, a whole row, the door's terminal
    const Grammar grammar = parse_grammar(facade + "except 1.2.3.2 -> f(1) A\nexcept 1.3 ->\nexcept 2.1 -> +(45) B\n");
    for (const std::string symbol : {"Window", "Door"}) check_same_picture(grammar, inline_rule(grammar, symbol).grammar);
    const Grammar whole = parse_grammar(facade + "except 1.2.3 -> A\n");
    CHECK_THROWS_WITH(inline_rule(whole, "Window"), Catch::Contains("1.2.3"));
}

TEST_CASE("rules that do not always apply stay") {
    const Grammar grammar = parse_grammar(facade);
    CHECK_THROWS_AS(inline_rule(grammar, "Row"), InputError);
    CHECK_THROWS_AS(inline_rule(grammar, "A"), InputError);
    const Grammar captured = parse_grammar(
        "lsystem 1\ndefine m = 5\naxiom: P(2)\nP(m) : m > 0 -> Q P(m-1)\nQ -> f(m) A\nterminal A: path \"M0 0H1\"\n");
    CHECK_THROWS_WITH(inline_rule(captured, "Q"), Catch::Contains("parameter m"));
}

TEST_CASE("grouped modules draw the same picture, and inlined again give the same text") {
    const Grammar grammar = parse_grammar(facade + "except 1.2.3.2 -> f(1) A\nexcept 1.2.4.3 -> B\nexcept 2.1 -> +(45) B\n");
    const StringPlace window{StringPlace::In::production, 2};
    const GroupOptions both{.string = window, .first = 0, .last = 7, .name = "Pane"};
    const EditResult grouped = group_modules(grammar, both);
    CHECK(grouped.grammar.productions.size() == grammar.productions.size() + 1);
    check_same_picture(grammar, grouped.grammar);
    CHECK(to_text(inline_rule(grouped.grammar, "Pane").grammar) == to_text(grammar));
    const GroupOptions in_axiom{.string = {}, .first = 0, .last = 2, .name = "Wall"};
    check_same_picture(grammar, group_modules(grammar, in_axiom).grammar);
}

TEST_CASE("what cannot be a group is refused") {
    const Grammar grammar = parse_grammar(facade);
    const StringPlace row{StringPlace::In::production, 1};
    CHECK_THROWS_WITH(group_modules(grammar, {.string = row, .first = 0, .last = 1}), Catch::Contains("brackets"));
    CHECK_THROWS_WITH(group_modules(grammar, {.string = row, .first = 3, .last = 5}), Catch::Contains("symbol"));
    CHECK_THROWS_WITH(group_modules(grammar, {.string = row, .first = 0, .last = 6}), Catch::Contains("continues"));
    CHECK_THROWS_AS(group_modules(grammar, {.string = row, .first = 0, .last = 99}), InputError);
}
