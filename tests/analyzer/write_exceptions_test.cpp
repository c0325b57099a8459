#include <catch2/catch.hpp>

#include <algorithm>
#include <set>
#include <vector>

#include "analyzer/generate_rules.h"
#include "analyzer/group_residuals.h"
#include "analyzer/inline_groups.h"
#include "analyzer/order_rules.h"
#include "analyzer/regauge.h"
#include "closed_loop/shapes.h"
#include "lsystem/interpret.h"

using namespace rinceau;
using namespace rinceau::test;

namespace {

constexpr double pitch = 30;
constexpr double fine = 1e-6;

/// Squares in 6 columns and 5 rows, and a star (the last element) off the fourth square of the third row.
Scene squares_and_star() {
    Scene scene;
    for (int row = 0; row < 5; ++row) {
        for (int column = 0; column < 6; ++column) {
            scene.elements.push_back(placed(element(rectangle(10, 10), filled({})), translate({pitch * column, pitch * row})));
        }
    }
    scene.elements.push_back(placed(element(star(5), filled({200, 0, 0})), translate({3 * pitch + 2, 2 * pitch - 1}) * scale_by(4)));
    scene.viewport = {{-20, -20}, {6 * pitch, 5 * pitch}};
    return scene;
}

constexpr int square_behind_star = 15;

struct Found {
    Scene scene = squares_and_star();
    Instancing instancing = group_similar_elements(scene);
    RuleSet rules = generate_rules(starting_state(instancing, {}, drawing_diagonal(scene)), {}).rules;

    Item& item(int i) { return rules.items[static_cast<std::size_t>(i)]; }
    int item_of(int element) const {
        const auto at = std::ranges::find(rules.items, element, &Item::element);
        return static_cast<int>(at - rules.items.begin());
    }
    /// What stands there instead of an item: nothing (-1) or another item, which is then no root.
    void replace(int item_index, int by) {
        for (Item& above : rules.items) std::ranges::replace(above.members, item_index, by);
        if (by >= 0) item(by).alive = false;
    }
    WrittenGrammar written() const {
        const OrderedRules ordered = ordered_for_painting(with_inlined_groups(rules), {});
        return to_grammar(ordered, instancing, scene, fine);
    }
};

/// Each leaf of the grammar is drawn where its element is; no element of `but` is.
void check_draws_all_but(const Found& found, const Grammar& grammar, const WrittenGrammar& written, const std::set<int>& but) {
    const std::vector<Placement> placements = interpret(grammar);
    REQUIRE(placements.size() == written.element_of_leaf.size());
    CHECK(placements.size() == found.scene.elements.size() - but.size());
    for (std::size_t leaf = 0; leaf < placements.size(); ++leaf) {
        const int element = written.element_of_leaf[leaf];
        CHECK(but.count(element) == 0);
        CHECK(abs(placements[leaf].pose.translation - found.instancing.instances[static_cast<std::size_t>(element)].pose.translation) < 1e-3);
    }
}

}  // namespace

TEST_CASE("what is missing is an exception without a successor, and without it the grammar draws the regular picture") {
    Found found;
    found.replace(found.item_of(square_behind_star), -1);
    const WrittenGrammar written = found.written();
    REQUIRE(written.grammar.exceptions.size() == 1);
    CHECK(written.grammar.exceptions[0].successor.empty());
    CHECK(written.grammar.exceptions[0].address.size() == 3);
    check_draws_all_but(found, written.grammar, written, {square_behind_star});

    Grammar regular = written.grammar;
    regular.exceptions.clear();
    CHECK(interpret(regular).size() == found.scene.elements.size());
}

TEST_CASE("what stands in for something is drawn at its address, where it lies") {
    Found found;
    found.replace(found.item_of(square_behind_star), found.item_of(30));
    const WrittenGrammar written = found.written();
    REQUIRE(written.grammar.exceptions.size() == 1);
    CHECK(root_items(found.rules).size() == 1);
    check_draws_all_but(found, written.grammar, written, {square_behind_star});
    // Residuals go into the same exception.
    Instancing moved = found.instancing;
    moved.instances[30].pose.translation += Point{0.5, 0};
    const Residuals exact = with_residuals(written, moved, 1e-2);
    CHECK(exact.exceptions == 1);
    CHECK(exact.grammar.exceptions.size() == 1);
    found.instancing = moved;
    check_draws_all_but(found, exact.grammar, written, {square_behind_star});
}

TEST_CASE("a whole row may be missing") {
    Found found;
    const int square = found.item_of(0);
    int row = -1;
    for (std::size_t i = 0; i < found.rules.items.size(); ++i) {
        if (std::ranges::count(found.rules.items[i].members, square) > 0) row = static_cast<int>(i);
    }
    REQUIRE(row >= 0);
    std::set<int> gone;
    for (const int element : elements_below(found.rules, row)) gone.insert(element);
    found.replace(row, -1);
    const WrittenGrammar written = found.written();
    REQUIRE(written.grammar.exceptions.size() == 1);
    CHECK(written.grammar.exceptions[0].address.size() == 2);
    check_draws_all_but(found, written.grammar, written, gone);
}

TEST_CASE("gaps stay where they are when their item is looked at from another side") {
    Found found;
    found.replace(found.item_of(square_behind_star), found.item_of(30));
    found.replace(found.item_of(2), -1);
    const int root = root_items(found.rules).front();
    const Part& part = found.rules.parts[static_cast<std::size_t>(found.item(root).part)];
    REQUIRE(part.symmetry.elements.size() >= 2);
    const Similarity pose = found.item(root).pose;
    for (const Similarity& gauge : part.symmetry.elements) {
        Found turned = found;
        regauge(turned.rules, root, pose * gauge);
        const WrittenGrammar written = turned.written();
        CHECK(written.grammar.exceptions.size() == 2);
        check_draws_all_but(turned, written.grammar, written, {2, square_behind_star});
    }
}

TEST_CASE("a group that is missing somewhere is not spliced into another") {
    RuleSet rules;
    for (int look = 0; look < 3; ++look) {
        Part part;
        part.look = look;
        rules.parts.push_back(part);
    }
    rules.rules.push_back({.kind = RuleKind::group, .members = {{0, {}}, {1, translate({1, 0})}}});
    rules.rules.push_back({.kind = RuleKind::group, .members = {{2, {}}, {3, translate({0, 1})}}});
    rules.parts.push_back({.rule = 0, .children = {{0, {}}, {1, translate({1, 0})}}, .leaves = 2});
    rules.parts.push_back({.rule = 1, .children = {{2, {}}, {3, translate({0, 1})}}, .leaves = 3});
    rules.items.push_back({.part = 2, .element = 0, .alive = false});
    rules.items.push_back({.part = 4, .members = {0, -1}});
    CHECK(with_inlined_groups(rules).parts[4].children.size() == 2);
    CHECK(elements_below(with_inlined_groups(rules), 1) == std::vector<int>{0});
}
