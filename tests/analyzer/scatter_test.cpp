#include "analyzer/scatter.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <map>

#include "analyzer/generate_rules.h"
#include "analyzer/group_residuals.h"
#include "analyzer/order_rules.h"
#include "closed_loop/scenes.h"
#include "closed_loop/shapes.h"
#include "geometry/random.h"
#include "lsystem/grammar_text.h"
#include "lsystem/interpret.h"

using namespace rinceau;
using namespace rinceau::test;

namespace {

constexpr double pitch = 30;
constexpr double tolerance = 1e-2;

/// A grid of houses, whose outline has no symmetry of rotation, as rules that draw it exactly.
struct Houses {
    Instancing instancing;
    WrittenGrammar written;

    Houses(int columns, int rows) {
        const std::vector<Path> outline{polygon({{-6, -5}, {6, -5}, {6, 3}, {0, 8}, {-6, 3}})};
        Scene scene;
        for (int column = 0; column < columns; ++column) {
            for (int row = 0; row < rows; ++row) {
                const Element house = element(outline, filled({}));
                scene.elements.push_back(placed(house, translate({1.5 * pitch * column, pitch * row})));
            }
        }
        scene.viewport = {{-20, -20}, {1.5 * pitch * columns, pitch * rows}};
        instancing = group_similar_elements(scene);
        const SearchState state = generate_rules(starting_state(instancing, {}, drawing_diagonal(scene)), {});
        constexpr double fine = 1e-5;
        written = to_grammar(ordered_for_painting(state.rules, {}), instancing, scene, fine);
    }
};

/// All numbers in normal(..) of the productions: mean, deviation, mean, ..
std::vector<double> normals_in(const Grammar& grammar) {
    std::vector<double> numbers;
    for (const Production& production : grammar.productions) {
        for (const ModuleTemplate& module : production.successor) {
            for (const Expression& argument : module.arguments) {
                for (std::size_t i = 2; i < argument.postfix.size(); ++i) {
                    if (argument.postfix[i].name != "normal") continue;
                    numbers.push_back(argument.postfix[i - 2].number);
                    numbers.push_back(argument.postfix[i - 1].number);
                }
            }
        }
    }
    return numbers;
}

/// By element: how far a grammar draws it from where the rules have it.
std::vector<Point> misses(const Grammar& grammar, const WrittenGrammar& written, std::uint64_t seed) {
    std::vector<Placement> regular = interpret(written.grammar), drawn = interpret(grammar, {.derive = {.seed = seed}});
    REQUIRE(drawn.size() == regular.size());
    std::ranges::sort(regular, {}, &Placement::order);
    std::ranges::sort(drawn, {}, &Placement::order);
    std::vector<Point> result(regular.size());
    for (std::size_t leaf = 0; leaf < regular.size(); ++leaf) {
        result[static_cast<std::size_t>(written.element_of_leaf[leaf])] =
            drawn[leaf].pose.translation - regular[leaf].pose.translation;
    }
    return result;
}

double deviation_of(const std::vector<Point>& points, double Point::*coordinate) {
    double sum = 0;
    for (const Point& point : points) sum += point.*coordinate * point.*coordinate;
    return std::sqrt(sum / static_cast<double>(points.size()));
}

}  // namespace

TEST_CASE("elements that scatter give noise of their deviation, and every seed draws a relative") {
    const Houses houses(12, 15);
    REQUIRE(houses.written.grammar.productions.size() == 2);
    Instancing moved = houses.instancing;
    Random random(7);
    for (Instance& instance : moved.instances) {
        const Similarity shifted = translate({2 * random.normal(), 1.2 * random.normal()});
        instance.pose = shifted * instance.pose * rotate(0.07 * random.normal()) * scale_by(std::exp(0.1 * random.normal()));
    }
    const Residuals found = with_scatter(houses.written, moved, tolerance);
    CHECK(found.exceptions == 0);
    CHECK(found.grammar.exceptions.empty());
    CHECK(found.grammar.seed == 1U);
    const Grammar read = parse_grammar(to_text(found.grammar));
    std::vector<double> numbers = normals_in(read);
    REQUIRE(numbers.size() == 8);  // ahead, right, turn, size
    std::vector<double> shifts{numbers[1], numbers[3]};
    std::ranges::sort(shifts);
    CHECK(shifts[0] == Approx(1.2).epsilon(0.2));
    CHECK(shifts[1] == Approx(2).epsilon(0.2));
    CHECK(numbers[5] == Approx(degrees(0.07)).epsilon(0.2));
    CHECK(numbers[7] == Approx(0.1).epsilon(0.2));

    const std::vector<Point> one = misses(read, houses.written, 1), two = misses(read, houses.written, 2);
    for (const auto& relative : {one, two}) {
        CHECK(deviation_of(relative, &Point::x) == Approx(2).epsilon(0.2));
        CHECK(deviation_of(relative, &Point::y) == Approx(1.2).epsilon(0.2));
    }
    for (std::size_t i = 0; i < one.size(); ++i) CHECK(abs(one[i] - two[i]) > 1e-6);
}

TEST_CASE("what does not scatter visibly gets no noise: elements shifted along rows alone stay on their rows") {
    const Houses houses(12, 15);
    Instancing moved = houses.instancing;
    Random random(3);
    for (Instance& instance : moved.instances) instance.pose.translation.x += 3 * random.normal();
    const Residuals found = with_scatter(houses.written, moved, tolerance);
    const std::vector<double> numbers = normals_in(found.grammar);
    REQUIRE(numbers.size() == 2);
    CHECK(numbers[0] == 0);
    CHECK(numbers[1] == Approx(3).epsilon(0.2));
    for (const Point& miss : misses(found.grammar, houses.written, 5)) CHECK(std::abs(miss.y) < tolerance);
}

TEST_CASE("groups that move as one move as one in the grammar") {
    const Houses houses(12, 5);
    // The rule that stands in the other one is the group.
    const std::vector<Placement> leaves = interpret(houses.written.grammar, {.addresses = true});
    std::map<std::vector<int>, Point> shift_of_group;
    Instancing moved = houses.instancing;
    Random random(11);
    for (const Placement& leaf : leaves) {
        const std::vector<int> group(leaf.address.begin(), leaf.address.end() - 1);
        const auto [at, added] = shift_of_group.try_emplace(group, Point{});
        if (added) at->second = {3 * random.normal(), 3 * random.normal()};
        const int element = houses.written.element_of_leaf[static_cast<std::size_t>(leaf.order)];
        moved.instances[static_cast<std::size_t>(element)].pose.translation += at->second;
    }
    REQUIRE(shift_of_group.size() >= 5);
    const Residuals found = with_scatter(houses.written, moved, tolerance);
    CHECK(found.exceptions == 0);
    const std::vector<double> numbers = normals_in(found.grammar);
    REQUIRE(numbers.size() == 4);
    // two members of a group miss their places by the same
    const std::vector<Point> missed = misses(found.grammar, houses.written, 2);
    std::map<std::vector<int>, Point> first;
    for (const Placement& leaf : leaves) {
        const std::vector<int> group(leaf.address.begin(), leaf.address.end() - 1);
        const Point miss =
            missed[static_cast<std::size_t>(houses.written.element_of_leaf[static_cast<std::size_t>(leaf.order)])];
        CHECK(abs(miss - first.try_emplace(group, miss).first->second) < 1e-9);
        CHECK(abs(miss) > 1e-3);
    }
}

TEST_CASE("single elements that stand elsewhere keep their exceptions, and a regular drawing has no noise") {
    const Houses houses(6, 5);
    Instancing moved = houses.instancing;
    moved.instances[3].pose.translation += Point{9, -3};
    moved.instances[17].pose = moved.instances[17].pose * rotate(0.3);
    CHECK(to_text(with_scatter(houses.written, moved, tolerance).grammar) ==
          to_text(with_residuals(houses.written, moved, tolerance).grammar));
    CHECK(to_text(with_scatter(houses.written, houses.instancing, tolerance).grammar) == to_text(houses.written.grammar));
}
