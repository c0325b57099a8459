#include <catch2/catch.hpp>

#include <algorithm>
#include <numeric>

#include "analyzer/paint_order.h"
#include "closed_loop/known_grammar.h"
#include "closed_loop/shapes.h"
#include "geometry/random.h"
#include "lsystem/interpret.h"

using namespace rinceau;
using namespace rinceau::test;

namespace {

Grammar grammar_of(const std::string& rules) {
    return known_grammar(rules, {{"A", element(circle(), filled({255, 0, 0}))}, {"B", element(circle(), filled({0, 0, 255}))}});
}

std::vector<Placement> in_order_of_derivation(const Grammar& grammar) {
    std::vector<Placement> leaves = interpret(grammar);
    std::sort(leaves.begin(), leaves.end(), [](const Placement& a, const Placement& b) { return a.order < b.order; });
    return leaves;
}

std::size_t leaf_count(const Grammar& grammar) { return interpret(grammar).size(); }

int layer_commands(const Grammar& grammar) {
    const auto count = [](const std::vector<ModuleTemplate>& string) {
        return static_cast<int>(std::count_if(string.begin(), string.end(), [](const auto& m) { return m.symbol == "z"; }));
    };
    int sum = count(grammar.axiom);
    for (const Production& production : grammar.productions) sum += count(production.successor);
    return sum;
}

/// Pairs of leaves, the lower one first, as pairs of elements; `element_of_leaf` must agree.
Overlaps pairs_of_leaves(const std::vector<std::pair<int, int>>& lower_upper, const std::vector<int>& element_of_leaf) {
    Overlaps overlaps;
    for (const auto& [lower, upper] : lower_upper) {
        overlaps.pairs.push_back({element_of_leaf[static_cast<std::size_t>(lower)], element_of_leaf[static_cast<std::size_t>(upper)]});
    }
    for (const OverlapPair& pair : overlaps.pairs) REQUIRE(pair.lower < pair.upper);
    std::sort(overlaps.pairs.begin(), overlaps.pairs.end(), [](const OverlapPair& a, const OverlapPair& b) {
        return a.upper != b.upper ? a.upper < b.upper : a.lower < b.lower;
    });
    return overlaps;
}

/// Every pair is painted in the drawing's order, and everything stands where it stood.
void check_painted_right(const Grammar& before, const Grammar& after, const std::vector<int>& element_of_leaf, const Overlaps& overlaps) {
    const std::vector<Placement> painted = interpret(after);
    const std::vector<Placement> leaves = in_order_of_derivation(before);
    REQUIRE(painted.size() == leaves.size());
    std::vector<std::size_t> position(painted.size());
    for (std::size_t k = 0; k < painted.size(); ++k) {
        const auto leaf = static_cast<std::size_t>(painted[k].order);
        position[static_cast<std::size_t>(element_of_leaf[leaf])] = k;
        CHECK(painted[k].pose == leaves[leaf].pose);
        CHECK(painted[k].terminal == leaves[leaf].terminal);
    }
    int wrong = 0;
    for (const OverlapPair& pair : overlaps.pairs) {
        wrong += position[static_cast<std::size_t>(pair.lower)] > position[static_cast<std::size_t>(pair.upper)];
    }
    CHECK(wrong == 0);
}

std::vector<int> identity(std::size_t count) {
    std::vector<int> elements(count);
    std::iota(elements.begin(), elements.end(), 0);
    return elements;
}

/// Numbers elements so that leaves come in the order of `key`, ties by derivation.
template <class Key>
std::vector<int> painted_by(std::size_t count, Key key) {
    std::vector<int> leaves = identity(count);
    std::stable_sort(leaves.begin(), leaves.end(), [&](int a, int b) { return key(a) < key(b); });
    std::vector<int> element_of_leaf(count);
    for (std::size_t i = 0; i < count; ++i) element_of_leaf[static_cast<std::size_t>(leaves[i])] = static_cast<int>(i);
    return element_of_leaf;
}

/// In a random one of `layers` layers each.
std::vector<int> painted_at_random(std::size_t count, std::uint32_t layers, Random& random) {
    std::vector<std::uint32_t> keys;
    for (std::size_t i = 0; i < count; ++i) keys.push_back(random.below(layers));
    return painted_by(count, [&](int leaf) { return keys[static_cast<std::size_t>(leaf)]; });
}

}  // namespace

TEST_CASE("a grammar that paints right stays as it is") {
    const Grammar grammar = grammar_of("axiom: P(5)\nP(m) : m > 0 -> [A] f(1) P(m-1)");
    const Grammar ordered = with_paint_order(grammar, identity(5), pairs_of_leaves({{0, 1}, {1, 2}, {3, 4}}, identity(5)));
    CHECK(layer_commands(ordered) == 0);
    CHECK(ordered.exceptions.empty());
}

TEST_CASE("all frames below all glasses takes one layer") {
    const Grammar grammar = grammar_of("axiom: P(6)\nP(m) : m > 0 -> [A] [f(0.5) B] f(1) P(m-1)");
    const std::vector<int> elements = painted_by(12, [](int leaf) { return leaf % 2; });
    std::vector<std::pair<int, int>> pairs;
    for (int i = 0; i < 6; ++i) {
        for (int j = std::max(0, i - 1); j < std::min(6, i + 2); ++j) pairs.emplace_back(2 * i, 2 * j + 1);
    }
    const Overlaps overlaps = pairs_of_leaves(pairs, elements);
    const Grammar ordered = with_paint_order(grammar, elements, overlaps);
    check_painted_right(grammar, ordered, elements, overlaps);
    CHECK(layer_commands(ordered) == 1);
    CHECK(ordered.exceptions.empty());
}

TEST_CASE("rows of scales are painted from either side") {
    const Grammar grammar = grammar_of("axiom: Q(5)\nQ(n) : n > 0 -> [P(7)] f(1) Q(n-1)\nP(m) : m > 0 -> [A] +(90) f(1) -(90) P(m-1)");
    for (const int across : {1, -1}) {
        for (const int up : {1, -1}) {
            const std::vector<int> elements = painted_by(35, [&](int leaf) { return up * (leaf / 7) * 100 + across * (leaf % 7); });
            std::vector<std::pair<int, int>> pairs;
            const auto add = [&](int i, int j) {
                const bool first = elements[static_cast<std::size_t>(i)] < elements[static_cast<std::size_t>(j)];
                pairs.emplace_back(first ? i : j, first ? j : i);
            };
            for (int i = 0; i < 35; ++i) {
                if (i % 7 < 6) add(i, i + 1);
                if (i < 28) add(i, i + 7);
            }
            const Overlaps overlaps = pairs_of_leaves(pairs, elements);
            const Grammar ordered = with_paint_order(grammar, elements, overlaps);
            check_painted_right(grammar, ordered, elements, overlaps);
            if (across == 1) {
                // Reversed rows move as rows: at most one exception each.
                CHECK(ordered.exceptions.size() <= (up == 1 ? 0U : 4U));
            }
        }
    }
}

TEST_CASE("the last petal of a ring goes under the first by one exception") {
    const Grammar grammar = grammar_of("axiom: P(12)\nP(m) : m > 0 -> [f(5) A] +(30) P(m-1)");
    const std::vector<int> elements = painted_by(12, [](int leaf) { return leaf == 11 ? 0 : 1; });
    std::vector<std::pair<int, int>> pairs;
    for (int i = 0; i < 12; ++i) {
        const int j = (i + 1) % 12;
        const bool first = elements[static_cast<std::size_t>(i)] < elements[static_cast<std::size_t>(j)];
        pairs.emplace_back(first ? i : j, first ? j : i);
    }
    const Overlaps overlaps = pairs_of_leaves(pairs, elements);
    const Grammar ordered = with_paint_order(grammar, elements, overlaps);
    check_painted_right(grammar, ordered, elements, overlaps);
    CHECK(layer_commands(ordered) == 0);
    CHECK(ordered.exceptions.size() == 1);
}

TEST_CASE("what lies below in most places and above in one gets an exception there only") {
    const Grammar grammar = grammar_of("axiom: P(8)\nP(m) : m > 0 -> [B] [A] f(3) P(m-1)");
    // B over A everywhere but in the fourth place, against the order of derivation.
    const auto key = [](int leaf) { return leaf / 2 == 3 ? leaf % 2 : 1 - leaf % 2; };
    const std::vector<int> elements = painted_by(16, key);
    std::vector<std::pair<int, int>> pairs;
    for (int i = 0; i < 8; ++i) pairs.emplace_back(2 * i + (i == 3 ? 0 : 1), 2 * i + (i == 3 ? 1 : 0));
    const Overlaps overlaps = pairs_of_leaves(pairs, elements);
    const Grammar ordered = with_paint_order(grammar, elements, overlaps);
    check_painted_right(grammar, ordered, elements, overlaps);
    CHECK(layer_commands(ordered) == 1);
    CHECK(ordered.exceptions.size() == 1);
}

TEST_CASE("a group that repeats is raised as a group") {
    const Grammar grammar = grammar_of("axiom: [P(9)] [+(90) f(2) Q]\nQ -> [P(9)] [f(4) P(9)]\nP(m) : m > 0 -> [A] f(1) P(m-1)");
    // The first row above the second group, which is above nothing else.
    const std::vector<int> elements = painted_by(27, [](int leaf) { return leaf < 9 ? 1 : 0; });
    std::vector<std::pair<int, int>> pairs;
    for (int i = 0; i < 9; ++i) pairs.emplace_back(9 + i, i);
    const Overlaps overlaps = pairs_of_leaves(pairs, elements);
    const Grammar ordered = with_paint_order(grammar, elements, overlaps);
    check_painted_right(grammar, ordered, elements, overlaps);
    CHECK(layer_commands(ordered) == 1);
    CHECK(ordered.exceptions.empty());
}

TEST_CASE("a layer ends where its module ends, and the turtle goes its way") {
    // Nothing here stands in brackets of its own.
    const Grammar grammar = grammar_of("axiom: A R A\nR -> f(3) A f(1) B f(2)");
    const std::vector<int> elements = painted_by(4, [](int leaf) { return -leaf; });
    const Overlaps overlaps = pairs_of_leaves({{1, 0}, {2, 1}, {3, 2}}, elements);
    const Grammar ordered = with_paint_order(grammar, elements, overlaps);
    check_painted_right(grammar, ordered, elements, overlaps);
}

TEST_CASE("an exception that is there already keeps its successor") {
    const Grammar grammar = grammar_of(
        "axiom: P(6)\nP(m) : m > 0 -> [A] f(3) P(m-1)\nexcept 1.2 -> B\nexcept 1.4 -> [B] f(1) A\nexcept 1.5 ->");
    const std::size_t count = leaf_count(grammar);
    REQUIRE(count == 6);
    Random random(5);
    for (int k = 0; k < 50; ++k) {
        const std::vector<int> elements = painted_at_random(count, 3, random);
        std::vector<std::pair<int, int>> pairs;
        for (int i = 0; i < 6; ++i) {
            for (int j = 0; j < i; ++j) {
                const bool first = elements[static_cast<std::size_t>(i)] < elements[static_cast<std::size_t>(j)];
                pairs.emplace_back(first ? i : j, first ? j : i);
            }
        }
        const Overlaps overlaps = pairs_of_leaves(pairs, elements);
        const Grammar ordered = with_paint_order(grammar, elements, overlaps);
        check_painted_right(grammar, ordered, elements, overlaps);
    }
}

TEST_CASE("whatever the order of the drawing, it is painted so") {
    const std::vector<std::string> rules{
        "axiom: P(9) A\nP(m) : m > 0 -> A f(1) P(m-1)",
        "axiom: Q(4) [f(9) P(3)] B\nQ(n) : n > 0 -> [P(n)] [B] f(1) Q(n-1)\nP(m) : m > 0 -> [A] [z(1) B] f(1) P(m-1)",
        "axiom: [W] [f(8) W] f(3) W\nW -> [A] [f(1) V] [f(2) V]\nV -> A B A",
        "axiom: A A B A B B A A B B A"};
    Random random(6);
    for (const std::string& rule : rules) {
        const Grammar grammar = grammar_of(rule);
        const std::size_t count = leaf_count(grammar);
        for (int k = 0; k < 60; ++k) {
            const std::vector<int> elements = painted_at_random(count, 1 + static_cast<std::uint32_t>(k), random);
            Overlaps overlaps;
            for (int upper = 1; upper < static_cast<int>(count); ++upper) {
                for (int lower = 0; lower < upper; ++lower) {
                    if (random.below(4) == 0) overlaps.pairs.push_back({lower, upper});
                }
            }
            check_painted_right(grammar, with_paint_order(grammar, elements, overlaps), elements, overlaps);
        }
    }
}

TEST_CASE("columns that lie row upon row take one layer for each repetition") {
    constexpr int columns = 6, rows = 5;
    const Grammar grammar = grammar_of("axiom: G(6)\nG(m) : m > 0 -> [C(5)] +(90) f(1) -(90) G(m-1)\nC(m) : m > 0 -> [A] f(1) C(m-1)");
    std::vector<int> element_of_leaf;  // the drawing goes row by row
    for (int column = 0; column < columns; ++column) {
        for (int row = 0; row < rows; ++row) element_of_leaf.push_back(row * columns + column);
    }
    std::vector<std::pair<int, int>> pairs;
    for (int column = 0; column < columns; ++column) {
        for (int row = 0; row + 1 < rows; ++row) {
            for (const int other : {column - 1, column, column + 1}) {
                if (other >= 0 && other < columns) pairs.emplace_back(column * rows + row, other * rows + row + 1);
            }
        }
    }
    const Overlaps overlaps = pairs_of_leaves(pairs, element_of_leaf);
    const Grammar ordered = with_paint_order(grammar, element_of_leaf, overlaps);
    check_painted_right(grammar, ordered, element_of_leaf, overlaps);
    CHECK(ordered.exceptions.empty());
    CHECK(layer_commands(ordered) == 1);
}

TEST_CASE("every other one above its neighbours is a layer that follows the counter") {
    constexpr int rows = 3, places = 8;
    const Grammar grammar = grammar_of("axiom: G(3)\nG(m) : m > 0 -> [R(8)] f(9) G(m-1)\nR(m) : m > 0 -> [A] +(90) f(1) -(90) R(m-1)");
    std::vector<int> element_of_leaf;  // of each row, the drawing has first those with even places
    for (int row = 0; row < rows; ++row) {
        for (int place = 0; place < places; ++place)
            element_of_leaf.push_back(row * places + place / 2 + (place % 2 == 1 ? places / 2 : 0));
    }
    std::vector<std::pair<int, int>> pairs;
    for (int row = 0; row < rows; ++row) {
        for (int place = 1; place < places; place += 2) {
            for (const int beside : {place - 1, place + 1}) {
                if (beside < places) pairs.emplace_back(row * places + beside, row * places + place);
            }
        }
    }
    const Overlaps overlaps = pairs_of_leaves(pairs, element_of_leaf);
    const Grammar ordered = with_paint_order(grammar, element_of_leaf, overlaps);
    check_painted_right(grammar, ordered, element_of_leaf, overlaps);
    CHECK(ordered.exceptions.empty());
    CHECK(layer_commands(ordered) == 1);
}
