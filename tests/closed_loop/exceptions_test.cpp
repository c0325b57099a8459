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
Scene tiles(const std::vector<Place>& places, const Element& look = tile()) {
    constexpr double pitch = 25;
    Scene scene;
    for (const auto& [column, row] : places) {
        scene.elements.push_back(placed(look, translate({pitch * column, pitch * row}) * scale_by(10)));
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
    const Element square = element(rectangle(1, 1), filled({60, 60, 200})), disc = element(circle(0.7), filled({60, 200, 60}));
    for (const Element& look : {tile(), square, disc}) {
        for (const int count : {1, 3, 8}) {
            const std::set<Place> holes = random_holes(count, static_cast<std::uint64_t>(count));
            const Analysis found = analyze(tiles(grid(10, 10, [&](int c, int r) { return holes.count({c, r}) == 0; }), look));
            INFO(count << " holes: " << rules_in_words(found.report));
            CHECK(rules_in_words(found.report) == "sequence of 10; sequence of 10");
            CHECK(axiom_symbols(found.grammar) == 1);
            CHECK(found.report.check.passed);
            REQUIRE(found.grammar.exceptions.size() == static_cast<std::size_t>(count));
            for (const Exception& exception : found.grammar.exceptions) CHECK(exception.successor.empty());
            CHECK(leaves_without_exceptions(found.grammar) == 100);
        }
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

TEST_CASE("a square grid of discs is rows of one length in a column") {
    const Analysis found = analyze(tiles(grid(9, 9, [](int, int) { return true; }), element(circle(0.7), filled({60, 200, 60}))));
    CHECK(rules_in_words(found.report) == "sequence of 9; sequence of 9");
    CHECK(axiom_symbols(found.grammar) == 1);
    CHECK(found.grammar.exceptions.empty());
}

TEST_CASE("a facade of windows of two parts has its doors as exceptions") {
    const Element frame = element(rectangle(20, 30), filled({30, 50, 80})), pane = element(rectangle(14, 12), filled({150, 200, 255})),
                  door = element(rectangle(24, 36), filled({120, 70, 0}));
    Scene scene;
    for (const auto& [column, row] : grid(12, 8, [](int, int) { return true; })) {
        const Similarity place = translate({40.0 * column, 45.0 * row});
        const bool is_door = row == 0 && (column == 3 || column == 8);
        if (is_door) {
            scene.elements.push_back(placed(door, place * translate({0, -3})));
        } else {
            scene.elements.push_back(placed(frame, place));
            scene.elements.push_back(placed(pane, place * translate({0, 4})));
        }
    }
    scene.viewport = {{-20, -30}, {470, 350}};
    const Analysis found = analyze(scene);
    CHECK(found.report.productions.size() == 3);
    CHECK(axiom_symbols(found.grammar) == 1);
    CHECK(found.report.check.passed);
    REQUIRE(found.grammar.exceptions.size() == 2);
    for (const Exception& exception : found.grammar.exceptions) CHECK_FALSE(exception.successor.empty());
    CHECK(leaves_without_exceptions(found.grammar) == 2 * 96);
}

TEST_CASE("a window without its pane is a window, and so is one with a curtain") {
    const Element frame = element(rectangle(20, 30), filled({30, 50, 80})), pane = element(rectangle(14, 12), filled({150, 200, 255})),
                  curtain = element(star(5), filled({250, 200, 60}));
    const std::set<Place> open{{4, 2}, {5, 2}, {1, 1}, {9, 5}};
    Scene scene;
    for (const auto& [column, row] : grid(10, 6, [](int, int) { return true; })) {
        const Similarity place = translate({40.0 * column, 45.0 * row});
        scene.elements.push_back(placed(frame, place));
        if (column == 3 && row == 3) {
            scene.elements.push_back(placed(curtain, place * translate({0, 5}) * scale_by(6)));
        } else if (open.count({column, row}) == 0) {
            scene.elements.push_back(placed(pane, place * translate({0, 4})));
        }
    }
    scene.viewport = {{-20, -30}, {390, 260}};
    const Analysis found = analyze(scene);
    CHECK(found.report.productions.size() == 3);
    CHECK(axiom_symbols(found.grammar) == 1);
    CHECK(found.report.check.passed);
    REQUIRE(found.grammar.exceptions.size() == 5);
    for (const Exception& exception : found.grammar.exceptions) CHECK(exception.address.size() == 4);
    CHECK(leaves_without_exceptions(found.grammar) == 120);
}

TEST_CASE("rings of many members may lack several, and a ring among others one") {
    const Element petal = element(leaf(), filled({50, 150, 50}));
    Scene scene;
    for (int k = 0; k < 36; ++k) {
        if (k == 15 || k == 17 || k == 26 || k == 30) continue;
        scene.elements.push_back(placed(petal, rotate(two_pi * k / 36) * translate({0, 200}) * scale_by(10)));
    }
    scene.viewport = {{-220, -220}, {220, 220}};
    const Analysis clock = analyze(scene);
    CHECK(rules_in_words(clock.report) == "ring of 36");
    CHECK(clock.grammar.exceptions.size() == 4);

    Scene flowers;
    for (const auto& [column, row] : grid(4, 3, [](int, int) { return true; })) {
        for (int k = 0; k < 7; ++k) {
            if (column == 2 && row == 0 && k == 3) continue;
            const Similarity at = translate({130.0 * column, 130.0 * row}) * rotate(two_pi * k / 7) * translate({0, 40});
            flowers.elements.push_back(placed(petal, at * scale_by(10)));
        }
    }
    flowers.viewport = {{-60, -60}, {450, 320}};
    const Analysis found = analyze(flowers);
    CHECK(found.report.productions.size() == 3);
    CHECK(axiom_symbols(found.grammar) == 1);
    CHECK(found.grammar.exceptions.size() == 1);
}

TEST_CASE("a ring that lacks a member, or has another thing in its place, is the ring") {
    const Element disc = element(circle(), filled({60, 200, 60})), other = element(star(5), filled({200, 0, 200}));
    for (const Element& look : {tile(), disc}) {
        for (const bool replaced : {false, true}) {
            Scene scene;
            for (int k = 0; k < 12; ++k) {
                if (k == 4 && !replaced) continue;
                const Similarity place = rotate(two_pi * k / 12) * translate({0, 100}) * scale_by(8);
                scene.elements.push_back(placed(k == 4 ? other : look, place));
            }
            scene.viewport = {{-120, -120}, {120, 120}};
            const Analysis found = analyze(scene);
            CHECK(rules_in_words(found.report) == "ring of 12");
            CHECK(axiom_symbols(found.grammar) == 1);
            CHECK(found.report.check.passed);
            REQUIRE(found.grammar.exceptions.size() == 1);
            CHECK(found.grammar.exceptions[0].successor.empty() == !replaced);
            CHECK(leaves_without_exceptions(found.grammar) == 12);
        }
    }
}

TEST_CASE("an arc that is far from closing is no ring") {
    Scene scene;
    for (int k = 0; k < 8; ++k) scene.elements.push_back(placed(tile(), rotate(two_pi * k / 12) * translate({0, 100}) * scale_by(8)));
    scene.viewport = {{-120, -120}, {120, 120}};
    const Analysis found = analyze(scene);
    CHECK(rules_in_words(found.report) == "sequence of 8");
    CHECK(found.grammar.exceptions.empty());
}

TEST_CASE("rows that lack a member at an end are rows of the grid") {
    const std::set<Place> holes{{0, 1}, {7, 2}, {7, 5}, {3, 4}};
    const Analysis found = analyze(tiles(grid(8, 8, [&](int c, int r) { return holes.count({c, r}) == 0; })));
    CHECK(rules_in_words(found.report) == "sequence of 8; sequence of 8");
    CHECK(axiom_symbols(found.grammar) == 1);
    CHECK(found.grammar.exceptions.size() == 4);
}

TEST_CASE("a brick wall with half bricks at the borders is rows that alternate, and the halves") {
    const Element brick = element(rectangle(22, 10), filled({180, 80, 60})), half = element(rectangle(10, 10), filled({180, 80, 60}));
    Scene scene;
    for (int row = 0; row < 9; ++row) {
        const bool even = row % 2 == 0;
        for (int column = 0; column < (even ? 8 : 7); ++column) {
            scene.elements.push_back(placed(brick, translate({24.0 * column + (even ? 0 : 12), 12.0 * row})));
        }
        if (even) continue;
        scene.elements.push_back(placed(half, translate({-6, 12.0 * row})));
        scene.elements.push_back(placed(half, translate({24 * 7 + 6, 12.0 * row})));
    }
    scene.viewport = {{-12, -6}, {180, 102}};
    const Analysis found = analyze(scene);
    INFO(rules_in_words(found.report));
    CHECK(found.report.productions.size() <= 5);
    CHECK(axiom_symbols(found.grammar) <= 2);
    CHECK(found.grammar.exceptions.size() <= 1);
    CHECK(found.report.check.passed);
}

TEST_CASE("equal blocks with gaps between them are blocks, not a row with holes") {
    const Analysis blocks = analyze(tiles(grid(19, 1, [](int c, int) { return c % 4 != 3; })));
    CHECK(rules_in_words(blocks.report) == "sequence of 3; sequence of 5");
    CHECK(blocks.grammar.exceptions.empty());

    const Analysis halves = analyze(tiles(grid(11, 1, [](int c, int) { return c != 5; })));
    CHECK(rules_in_words(halves.report) == "sequence of 2; sequence of 5");
    CHECK(halves.grammar.exceptions.empty());

    // Under a whole row as well: the gaps are even.
    const Analysis fence = analyze(tiles(grid(15, 5, [](int c, int r) { return r == 0 || r == 4 || c % 3 != 1; })));
    CHECK(fence.grammar.exceptions.empty());

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
