// What holds of a finished arrangement: distances, outlines, lines, brushes.

#include <catch2/catch.hpp>
#include <cmath>
#include <memory>

#include "growth/arrangement/grow_arrangement.h"
#include "growth/arrangement/outline_contact.h"
#include "growth/arrangement/paint_order.h"
#include "tests/growth/lattice_points.h"

namespace rinceau {

namespace {

Exemplar irregular() { return make_exemplar(irregular_points(99), {"A", "B"}, {}, "irregular"); }
Exemplar bricks() { return make_exemplar(lattice_kinds()[3].points, {"A"}, {}, "bricks"); }

void check_apart(const ElementArrangement& arrangement, const Exemplar& exemplar) {
    const ArrangeSurroundings around;
    const GrowthGround ground = make_ground(exemplar, around, arrangement.options);
    const std::vector<int> nodes = nodes_by_birth(arrangement);
    int overlaps = 0;
    int crowded = 0;
    for (const int node : nodes) {
        const ArrangementNode& a = arrangement.nodes[static_cast<std::size_t>(node)];
        overlaps += overlapped_elements(arrangement, ground, placed_reference(a), node).empty() ? 0 : 1;
        for (const int other : nodes) {
            const ArrangementNode& b = arrangement.nodes[static_cast<std::size_t>(other)];
            if (other <= node) continue;
            crowded += abs(a.position - b.position) < 0.97 * least_distance(ground, a.symbol, b.symbol) ? 1 : 0;
        }
    }
    CHECK(overlaps == 0);
    CHECK(crowded == 0);
}

int cut_by(const Boundary& boundary, const Exemplar& exemplar, const ElementArrangement& arrangement) {
    int cut = 0;
    for (const ArrangedElement& element : arranged_elements(arrangement)) {
        const Region& outline = exemplar.elements[static_cast<std::size_t>(element.reference)].outline;
        cut += boundary.cuts(outline, translate(element.position) * rotate(element.angle)) ? 1 : 0;
    }
    return cut;
}

}  // namespace

TEST_CASE("a finished irregular arrangement has as many elements as were asked for, and none too close to another") {
    const Exemplar exemplar = irregular();
    for (const RotationMode mode : {RotationMode::fixed, RotationMode::rotate}) {
        ElementArrangement arrangement = with_seed(empty_arrangement(exemplar, {.mode = mode}), exemplar, {}, {0, 0});
        const GrowOrder order{.count = 300};
        arrangement = finished(grow(std::move(arrangement), exemplar, {}, order), exemplar, {}, order);
        CHECK(arrangement.elements <= 300);
        CHECK(arrangement.elements >= 297);
        check_apart(arrangement, exemplar);
        // Both shares are as they were drawn, to within a tenth.
        for (std::size_t symbol = 0; symbol < 2; ++symbol) {
            const double share = static_cast<double>(arrangement.counts[symbol]) / static_cast<double>(arrangement.elements);
            CHECK(share == Approx(exemplar.symbols[symbol].share).epsilon(0.1));
        }
    }
}

TEST_CASE("a finished arrangement can grow on and be finished again") {
    const Exemplar exemplar = irregular();
    ElementArrangement arrangement = with_seed(empty_arrangement(exemplar, {}), exemplar, {}, {0, 0});
    for (const std::size_t count : {100U, 200U}) {
        arrangement = grow(std::move(arrangement), exemplar, {}, {.count = count});
        CHECK(arrangement.elements == count);
        arrangement = finished(std::move(arrangement), exemplar, {}, {.count = count});
        check_apart(arrangement, exemplar);
    }
}

TEST_CASE("no outline leaves the region or crosses a line, however it was grown") {
    for (const Exemplar& exemplar : {irregular(), bricks()}) {
        const double l = exemplar.mean_edge;
        const std::vector<Point> ring{{-8 * l, -8 * l}, {8 * l, -6 * l}, {2 * l, 0}, {8 * l, 8 * l}, {-8 * l, 7 * l}};
        ArrangeSurroundings around;
        around.boundary =
            std::make_shared<Boundary>(std::vector<Polyline>{{{-5 * l, 2 * l}, {-2 * l, -6 * l}}}, Region{ring});
        for (const RotationMode mode : {RotationMode::fixed, RotationMode::rotate}) {
            ElementArrangement arrangement =
                with_seed(empty_arrangement(exemplar, {.mode = mode}), exemplar, around, {0, 0});
            arrangement = grow(std::move(arrangement), exemplar, around, {});
            CHECK(cut_by(*around.boundary, exemplar, arrangement) == 0);
            arrangement = finished(std::move(arrangement), exemplar, around);
            CHECK(cut_by(*around.boundary, exemplar, arrangement) == 0);
            // It is full: half of what the area holds at the least, the rest is lost along the lines.
            CHECK(static_cast<double>(arrangement.elements) > 0.5 * area(*around.boundary->region()) * exemplar.density);
        }
    }
}

TEST_CASE("a regular pattern meets again behind a wall without a tear") {
    const Exemplar exemplar = bricks();
    const double l = exemplar.mean_edge;
    ArrangeSurroundings around;
    around.boundary = std::make_shared<Boundary>(std::vector<Polyline>{{{-4 * l, 3 * l}, {4 * l, 2 * l}}});
    ElementArrangement arrangement = with_seed(empty_arrangement(exemplar, {}), exemplar, around, {0, 0});
    arrangement = finished(grow(std::move(arrangement), exemplar, around, {.count = 400}), exemplar, around, {.count = 400});
    CHECK(arrangement.elements == 400);
    for (const ArrangementNode& node : arrangement.nodes)
        for (const RingLink& link : node.links)
            if (link.place >= 0)
                CHECK(abs(arrangement.nodes[static_cast<std::size_t>(link.other)].position - node.position - link.target) <
                      1e-6 * l);
}

TEST_CASE("what is sprayed grows under the brush and joins what stands") {
    const Exemplar exemplar = irregular();
    const double l = exemplar.mean_edge;
    ElementArrangement arrangement = empty_arrangement(exemplar, {});
    std::vector<Point> path;
    for (int i = 0; i <= 10; ++i) path.push_back({2.0 * i * l, 0});
    for (const Point at : path) {
        arrangement = with_seed(std::move(arrangement), exemplar, {}, at);
        arrangement = grow(std::move(arrangement), exemplar, {}, {.brush = Brush{at, 3 * l}});
    }
    CHECK(arrangement.elements > 60);
    for (const ArrangedElement& element : arranged_elements(arrangement)) {
        // Seeds are chosen below the brush; what they become is relaxed by less than an edge.
        const double along = std::min(std::max(element.position.x, 0.0), path.back().x);
        CHECK(abs(element.position - Point{along, 0}) < 4 * l);
    }
    // One piece: each element is linked with others.
    std::size_t lonely = 0;
    for (const ArrangementNode& node : arrangement.nodes) lonely += is_element(node) && node.links.empty() ? 1 : 0;
    CHECK(lonely == 0);
    check_apart(finished(std::move(arrangement), exemplar, {}), exemplar);
}

TEST_CASE("no seed grows while one of higher priority is within five edges") {
    const Exemplar exemplar = irregular();
    ElementArrangement arrangement =
        with_seed(empty_arrangement(exemplar, {.priorities = {1, 0}, .relax = false}), exemplar, {}, {0, 0});
    for (std::size_t count = 1; count <= 120; ++count) {
        const ElementArrangement before = arrangement;
        arrangement = grow(std::move(arrangement), exemplar, {}, {.count = count});
        const int placed = nodes_by_birth(arrangement).back();
        if (count == 1 || before.nodes[static_cast<std::size_t>(placed)].symbol == 0) continue;
        const Point at = before.nodes[static_cast<std::size_t>(placed)].position;
        for (const ArrangementNode& node : before.nodes)
            CHECK_FALSE((is_seed(node) && node.symbol == 0 && abs(node.position - at) < 5 * exemplar.mean_edge));
    }
}

TEST_CASE("scales are painted over each other as in the exemplar") {
    // Rows of scales from above, each over the two above it.
    std::vector<ExemplarPoint> points;
    for (int row = 7; row >= 0; --row)
        for (int column = 0; column < 8; ++column)
            points.push_back({{10.0 * column + (row % 2 == 0 ? 0 : 5), 6.0 * row}, 0, disc_outline(6)});
    const Exemplar exemplar = make_exemplar(points, {"A"}, {}, "scales");
    REQUIRE(exemplar.outlines_overlap);
    ElementArrangement arrangement = with_seed(empty_arrangement(exemplar, {}), exemplar, {}, {0, 0});
    arrangement = finished(grow(std::move(arrangement), exemplar, {}, {.count = 200}), exemplar, {}, {.count = 200});
    const std::vector<ArrangedElement> elements = arranged_elements(arrangement);
    const std::vector<std::size_t> order = paint_order(exemplar, elements);
    std::vector<std::size_t> when(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) when[order[i]] = i;
    REQUIRE(order.size() == 200);
    std::size_t pairs = 0;
    for (const auto& [a, b] : arranged_edges(arrangement)) {
        const double rise =
            elements[static_cast<std::size_t>(b)].position.y - elements[static_cast<std::size_t>(a)].position.y;
        if (std::abs(rise) < 1) continue;
        ++pairs;
        CHECK((when[static_cast<std::size_t>(a)] < when[static_cast<std::size_t>(b)]) == (rise < 0));
    }
    CHECK(pairs > 200);
}

}  // namespace rinceau
