#include "lsystem/edit_productions.h"

#include <algorithm>

#include <catch2/catch.hpp>

#include "lsystem/check_edit.h"
#include "lsystem/follow_numbers.h"
#include "lsystem/grammar_text.h"
#include "lsystem/interpret.h"
#include "lsystem/numbers.h"
#include "lsystem/to_scene.h"

using namespace rinceau;

namespace {

const std::string drawings = "terminal A: path \"M-1 0H1V-3H-1Z\"\nterminal B: path \"M-1 0H1V-5Z\"\n";

Grammar grammar_of(const std::string& body) { return parse_grammar("lsystem 1\n" + body + drawings); }

Grammar rows() {
    return grammar_of(
        "axiom: [Wall(2)] B\n"
        "Wall(m) : m > 0 -> [Row(3)] f(20) Wall(m-1)\n"
        "Row(m) : m > 1 -> [A] f(5) Row(m-1)\n"
        "Row(m) : m > 0 -> [B] f(7) Row(m-1)\n"
        "except 1.2 -> Row(1)\n");
}

std::size_t elements(const Grammar& grammar) { return interpret(grammar).size(); }

std::vector<Similarity> poses(const Grammar& grammar, const std::string& symbol) {
    std::vector<Similarity> result;
    for (const Placement& placement : interpret(grammar))
        if (grammar.terminals[static_cast<std::size_t>(placement.terminal)].symbol == symbol)
            result.push_back(placement.pose);
    return result;
}

void check_is_good(const Grammar& grammar) {
    const std::string text = to_text(grammar);
    INFO(text);
    CHECK(check_grammar(text).empty());
}

}  // namespace

TEST_CASE("a new production of every shape is drawn at once, and what was there stays where it was") {
    const Grammar before = rows();
    for (const auto& [shape, more] : {std::pair{ProductionShape::empty, 0},
                                      {ProductionShape::sequence, 5},
                                      {ProductionShape::ring, 6},
                                      {ProductionShape::branching, 15},
                                      {ProductionShape::group, 1}}) {
        const EditResult result = add_production(before, {.shape = shape, .elements = {"A"}});
        check_is_good(result.grammar);
        const int of_elements = shape == ProductionShape::empty ? 0 : more;
        CHECK(elements(result.grammar) == elements(before) + static_cast<std::size_t>(of_elements));
        const auto then = interpret(before);
        const auto now = interpret(result.grammar);
        for (std::size_t i = 0; i < then.size(); ++i) CHECK(now[i].pose == then[i].pose);
        CHECK(result.changes.size() == 1);
    }
}

TEST_CASE("elements of a new row or ring do not overlap") {
    const Grammar before = grammar_of("axiom: B\n");
    for (const ProductionShape shape : {ProductionShape::sequence, ProductionShape::ring}) {
        const Grammar after = add_production(before, {.shape = shape, .elements = {"A"}}).grammar;
        const auto list = poses(after, "A");
        for (std::size_t i = 0; i < list.size(); ++i)
            for (std::size_t k = 0; k < i; ++k) CHECK(abs(list[i].translation - list[k].translation) >= 2);
    }
}

TEST_CASE("a new production is in the middle of the picture, wherever the axiom has gone") {
    const Grammar before = grammar_of("canvas 0 -100 200 100\naxiom: f(33) +(20) *(3) A\n");
    const Grammar after = add_production(before, {.shape = ProductionShape::ring, .elements = {"B"}}).grammar;
    Point sum{};
    for (const Similarity& pose : poses(after, "B")) sum = sum + (1.0 / 6) * pose.translation;
    CHECK(sum.x == Approx(100).margin(0.5));
    CHECK(sum.y == Approx(50).margin(0.5));
}

TEST_CASE("names of new productions are free, elements known") {
    CHECK(add_production(rows(), {.symbol = "Row"}).grammar.productions.back().symbol == "Row2");
    CHECK_THROWS_WITH(add_production(rows(), {.elements = {"Rwo"}}), Catch::Contains("Row"));
    CHECK_THROWS_AS(add_production(rows(), {.symbol = "f"}), InputError);
    CHECK_THROWS_AS(add_production(rows(), {.symbol = "9a"}), InputError);
    CHECK_THROWS_AS(add_production(Grammar{}, {}), InputError);
}

TEST_CASE("a production that is used says where, and can go with its uses") {
    const Grammar before = rows();
    CHECK(reason_to_keep(before, 0).find("the axiom") != std::string::npos);
    CHECK_THROWS_WITH(remove_production(before, 0), Catch::Contains("the axiom"));
    CHECK(reason_to_keep(before, 1).empty());  // another production of Row is left
    const Grammar one_case = remove_production(before, 1).grammar;
    CHECK(one_case.productions.size() == 2);
    const Grammar without = remove_production(before, 0, true).grammar;
    for (const Production& production : without.productions) CHECK(production.successor.empty());  // a place is kept
    for (const char* gone : {"Wall", "Row", "A"}) CHECK(std::ranges::count(symbols_of(without), gone) == 0);
    CHECK(elements(without) == 1);
    check_is_good(without);
}

TEST_CASE("what follows the uses of a removed production stays where it is") {
    const Grammar before = grammar_of("axiom: Go B\nGo -> A f(40) +(30)\n");
    const Grammar after = remove_production(before, 0, true).grammar;
    REQUIRE(poses(after, "B").size() == 1);
    CHECK(abs(poses(after, "B")[0].translation - poses(before, "B")[0].translation) < 1e-9);
    CHECK(poses(after, "A").empty());
}

TEST_CASE("moving productions of different symbols changes nothing that is drawn, and there and back is the same") {
    const Grammar before = rows();
    const Grammar after = move_production(before, 0, 2).grammar;
    CHECK(after.productions[2].symbol == "Wall");
    CHECK(interpret(after).size() == interpret(before).size());
    CHECK(to_text(move_production(after, 2, 0).grammar) == to_text(before));
    const EditResult cases = move_production(before, 1, 2);
    CHECK(cases.changes.back().find("tried in another order") != std::string::npos);
    CHECK_THROWS_AS(move_production(before, 0, 3), InputError);
    CHECK_THROWS_AS(move_production(before, -1, 0), InputError);
}

TEST_CASE("a symbol is renamed wherever it stands") {
    const Grammar before = grammar_of(
        "axiom: [S] T S\n"
        "ignore T\n"
        "S < T > S -> A S\n"
        "S -> B\n"
        "except 2 -> S\n"
        "terminal T: path \"M-1 0H1V-5Z\"\n");
    const Grammar after = rename_symbol(before, "S", "Stem").grammar;
    const std::string text = to_text(after);
    CHECK(std::ranges::count(symbols_of(after), "S") == 0);
    CHECK(text.find("Stem < T > Stem -> A Stem") != std::string::npos);
    CHECK(to_text(rename_symbol(after, "Stem", "S").grammar) == to_text(before));
    CHECK(to_text(rename_symbol(before, "A", "Leaf").grammar).find("terminal Leaf:") != std::string::npos);
    CHECK(to_text(rename_symbol(before, "T", "Tip").grammar).find("ignore Tip") != std::string::npos);
    for (const char* wrong : {"B", "f", "define", "9a", "a b", "", "sin"})
        CHECK_THROWS_AS(rename_symbol(before, "S", wrong), InputError);
    CHECK_THROWS_WITH(rename_symbol(before, "Q", "R"), Catch::Contains("'Q'"));
}

TEST_CASE("comments are written as lines before the production") {
    const Grammar after = comment_production(rows(), 0, "A wall.\nOf rows.").grammar;
    CHECK(to_text(after).find("# A wall.\n# Of rows.\nWall(m)") != std::string::npos);
    CHECK(to_text(comment_production(after, 0, "").grammar) == to_text(rows()));
}

TEST_CASE("numbers are found again by other names after productions moved or a symbol was renamed") {
    const Grammar before = rows();
    const auto afterwards = [&](const Grammar& after, const std::vector<int>& index, const std::string& name) {
        const auto names = names_afterwards(before, after, index, {name});
        return names.empty() ? std::string() : *names.begin();
    };
    const Grammar swapped = move_production(before, 1, 2).grammar;
    CHECK(afterwards(swapped, {0, 2, 1}, "Row.distance") == "Row.case2.distance");
    CHECK(afterwards(swapped, {0, 2, 1}, "Row.case2.distance") == "Row.distance");
    CHECK(afterwards(swapped, {0, 2, 1}, "Wall.distance") == "Wall.distance");
    const Grammar renamed = rename_symbol(before, "Wall", "House").grammar;
    CHECK(afterwards(renamed, {0, 1, 2}, "Wall.count") == "House.count");
    CHECK(afterwards(renamed, {0, 1, 2}, "Wall.distance") == "House.distance");
    const Grammar fewer = remove_production(before, 1).grammar;
    CHECK(afterwards(fewer, {0, -1, 1}, "Row.distance").empty());
    CHECK(afterwards(fewer, {0, -1, 1}, "Row.case2.distance") == "Row.distance");
}
