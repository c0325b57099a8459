// A door in a grid of windows, a missing key, a half row at the border: the rule stays, with exceptions.

#include <catch2/catch.hpp>

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "closed_loop/findings.h"
#include "closed_loop/known_grammar.h"
#include "closed_loop/shapes.h"
#include "lsystem/interpret.h"

using namespace rinceau;
using namespace rinceau::test;

namespace {

using Place = std::pair<int, int>;  // column, row

Element tile() { return element(hook(), filled({200, 60, 40})); }

/// A tile of size 10 at each place of the list, `pitch` apart.
Scene tiles(const std::vector<Place>& places, double pitch = 25) {
    Scene scene;
    for (const auto& [column, row] : places) {
        scene.elements.push_back(placed(tile(), translate({pitch * column, pitch * row}) * scale_by(10)));
        scene.viewport = including(scene.viewport, painted_box(scene.elements.back()));
    }
    return scene;
}

std::vector<Place> grid(int columns, int rows, const std::function<bool(int, int)>& taken) {
    std::vector<Place> places;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            if (taken(column, row)) places.emplace_back(column, row);
        }
    }
    return places;
}

std::set<Place> random_holes(int count, std::uint64_t seed) {
    Random random(seed);
    std::set<Place> holes;
    while (static_cast<int>(holes.size()) < count) {
        const auto column = static_cast<int>(random.below(10)), row = static_cast<int>(random.below(10));
        holes.insert({column, row});
    }
    return holes;
}

std::size_t leaves_without_exceptions(Grammar grammar) {
    grammar.exceptions.clear();
    return interpret(grammar).size();
}

}  // namespace

TEST_CASE("a grid with a few tiles missing is the grid, with an exception for each hole") {
    for (const int count : {1, 3, 8}) {
        const std::set<Place> holes = random_holes(count, static_cast<std::uint64_t>(count));
        const Analysis found = analyze(tiles(grid(10, 10, [&](int c, int r) { return holes.count({c, r}) == 0; })));
        INFO(count << " holes: " << rules_in_words(found.report));
        CHECK(rules_in_words(found.report) == "sequence of 10; sequence of 10");
        CHECK(axiom_symbols(found.grammar) == 1);
        CHECK(found.report.check.passed);
        REQUIRE(found.grammar.exceptions.size() == static_cast<std::size_t>(count));
        for (const Exception& exception : found.grammar.exceptions) CHECK(exception.successor.empty());
        CHECK(leaves_without_exceptions(found.grammar) == 100);
    }
}

TEST_CASE("a row with gaps is one row") {
    const std::set<int> gaps{4, 9, 12};
    const Analysis found = analyze(tiles(grid(16, 1, [&](int c, int) { return gaps.count(c) == 0; })));
    CHECK(rules_in_words(found.report) == "sequence of 16");
    CHECK(found.grammar.exceptions.size() == 3);
    CHECK(leaves_without_exceptions(found.grammar) == 16);
}

TEST_CASE("a half row at the border of a grid stands where a whole one would, wherever it begins") {
    for (const int begin : {0, 3, 5}) {
        const Analysis found = analyze(tiles(grid(10, 8, [&](int c, int r) { return r < 7 || (c >= begin && c < begin + 5); })));
        INFO(begin << ": " << rules_in_words(found.report));
        CHECK(rules_in_words(found.report) == "sequence of 5 10; sequence of 8");
        CHECK(axiom_symbols(found.grammar) == 1);
        CHECK(found.grammar.exceptions.size() == 1);
        CHECK(found.report.check.passed);
        CHECK(leaves_without_exceptions(found.grammar) == 80);
    }
}

TEST_CASE("equal blocks with gaps between them are blocks, not a row with holes") {
    const Analysis blocks = analyze(tiles(grid(19, 1, [](int c, int) { return c % 4 != 3; })));
    CHECK(rules_in_words(blocks.report) == "sequence of 3; sequence of 5");
    CHECK(blocks.grammar.exceptions.empty());

    const Analysis halves = analyze(tiles(grid(11, 1, [](int c, int) { return c != 5; })));
    CHECK(rules_in_words(halves.report) == "sequence of 2; sequence of 5");
    CHECK(halves.grammar.exceptions.empty());

    const Analysis lattice = analyze(tiles(grid(19, 4, [](int c, int) { return c % 5 != 4; })));
    CHECK(lattice.grammar.exceptions.empty());
    CHECK(axiom_symbols(lattice.grammar) == 1);
}

TEST_CASE("nothing is stretched over random clutter") {
    Random random(7);
    Scene scene;
    for (int k = 0; k < 150; ++k) {
        const Point at{random.uniform(0, 400), random.uniform(0, 400)};
        scene.elements.push_back(placed(tile(), translate(at) * scale_by(10)));
    }
    scene.viewport = {{-10, -10}, {410, 410}};
    const Analysis found = analyze(scene);
    CHECK(found.report.productions.empty());
    CHECK(found.grammar.exceptions.empty());
}
