// Elements that a wall turns back must not pile up in front of it.

#include "growth/arrangement/stay_inside.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "geometry/angle.h"
#include "growth/arrangement/grow_arrangement.h"

namespace rinceau {
namespace {

/// Courses of scales, each over the one below.
Exemplar scales() {
    const Region scale{
        {{-14, 6}, {-14, -10}, {-10, -20}, {0, -24}, {10, -20}, {14, -10}, {14, 6}, {12, 10}, {0, 14}, {-12, 10}}};
    std::vector<ExemplarPoint> points;
    for (int row = 0; row < 8; ++row)
        for (int column = 0; column < 8; ++column)
            points.push_back({{23.0 * column + (row % 2 == 1 ? 11.5 : 0), 13.0 * row}, 0, scale, true});
    return make_exemplar(points, {"scale"}, {}, "scales");
}

ArrangeSurroundings room_with_flow(const Exemplar& exemplar, const Box& room, double wave) {
    Polyline stroke;
    constexpr int steps = 40;
    for (int i = 0; i <= steps; ++i)
        stroke.push_back({width(room) * i / steps, center(room).y + wave * std::sin(two_pi * i / steps)});
    const Region walls{{room.low, {room.high.x, room.low.y}, room.high, {room.low.x, room.high.y}}};
    return {std::make_shared<const FlowField>(
                make_flow_field(std::vector<Polyline>{stroke}, room, {.step = 0.5 * exemplar.mean_edge}, "flow")),
            std::make_shared<const Boundary>(std::vector<Polyline>{}, walls)};
}

}  // namespace

TEST_CASE("along a flow, overlapping elements fill a room once: what the walls turn back does not pile up") {
    const Exemplar exemplar = scales();
    REQUIRE(exemplar.outlines_overlap);
    const Box room{{0, 0}, {420, 300}};
    const double fitting = width(room) * height(room) * exemplar.density;
    for (const double wave : {0.0, 40.0, 80.0}) {
        INFO("wave " << wave);
        const ArrangeSurroundings around = room_with_flow(exemplar, room, wave);
        ElementArrangement arrangement =
            with_seed(empty_arrangement(exemplar, {.mode = RotationMode::flow}), exemplar, around, center(room));
        const GrowOrder order{.count = 1000};
        arrangement = grow(std::move(arrangement), exemplar, around, order);
        arrangement = finished(std::move(arrangement), exemplar, around, order);
        const std::vector<ArrangedElement> elements = arranged_elements(arrangement);
        CHECK(static_cast<double>(elements.size()) < fitting);
        CHECK(static_cast<double>(elements.size()) > 0.75 * fitting);
        double least = room.high.x;
        for (std::size_t i = 0; i < elements.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) least = std::min(least, abs(elements[i].position - elements[j].position));
        CHECK(least > 0.6 * exemplar.shortest_edge);
        for (const ArrangedElement& element : elements) {
            const Region& outline = exemplar.elements[static_cast<std::size_t>(element.reference)].outline;
            CHECK_FALSE(around.boundary->cuts(outline, translate(element.position) * rotate(element.angle)));
        }
    }
}

}  // namespace rinceau
