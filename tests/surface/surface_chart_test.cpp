#include "growth/surface/surface_chart.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>

#include "surface_directions.h"
#include "surface_shapes.h"

using namespace rinceau;

namespace {

Complex centre_of(const ChartTriangle& triangle) { return (triangle.at[0] + triangle.at[1] + triangle.at[2]) / 3; }

double area_of(const std::array<Complex, 3>& t) { return cross(t[1] - t[0], t[2] - t[0]) / 2; }

}  // namespace

TEST_CASE("a chart of the plane is the plane, turned so that x lies where asked") {
    const SurfaceMesh surface = surface_mesh(plane_triangles(20, 20, 1, 0.25));
    const SurfacePoint anchor = from_barycentric(surface, 421, {0.2, 0.5, 0.3});
    const SpacePoint origin = position_in_space(surface, anchor);
    const SurfaceChart chart = surface_chart(surface, anchor, in_face(surface, anchor.face, {0, 1, 0}), 6);
    CHECK(chart.good_radius == 6);
    CHECK_FALSE(chart.meets_border);
    for (const ChartTriangle& triangle : chart.triangles) {
        const ChartStretch stretch = stretch_of(surface, triangle);
        CHECK(stretch.largest == Approx(1).epsilon(1e-6));
        CHECK(stretch.smallest == Approx(1).epsilon(1e-6));
    }
    const ChartLookup lookup(surface, chart);
    Random random(9);
    for (int i = 0; i < 500; ++i) {
        const Complex place = polar(6 * std::sqrt(random.uniform()), random.uniform(-pi, pi));
        const auto found = lookup.find(place);
        REQUIRE(found);
        const SpacePoint exact = origin + SpacePoint{-place.y, place.x, 0};  // x of the chart is +y
        CHECK(abs(position_in_space(surface, found->at) - exact) < 1e-8);
        CHECK(abs(direction_in_space(surface, found->at.face, found->x) - SpacePoint{0, 1, 0}) < 1e-7);
    }
    CHECK_FALSE(lookup.find({9, 0}));
}

TEST_CASE("a chart covers every place within its radius once, from a face, an edge and a vertex") {
    const SurfaceMesh surface = surface_mesh(torus_triangles(60, 30, 2, 0.7));
    for (const auto& weights : {std::array{0.3, 0.3, 0.4}, std::array{0.5, 0.0, 0.5}, std::array{1.0, 0.0, 0.0}}) {
        const SurfacePoint anchor = from_barycentric(surface, 1717, weights);
        const SurfaceChart chart = surface_chart(surface, anchor, {0.6, 0.8}, 0.5);
        REQUIRE(chart.good_radius == 0.5);
        Random random(2);
        for (int i = 0; i < 300; ++i) {
            const Complex place = polar(0.499 * std::sqrt(random.uniform()), random.uniform(-pi, pi));
            int over = 0;
            for (const ChartTriangle& t : chart.triangles)
                over += cross(t.at[1] - t.at[0], place - t.at[0]) > 0 && cross(t.at[2] - t.at[1], place - t.at[1]) > 0 &&
                        cross(t.at[0] - t.at[2], place - t.at[2]) > 0;
            CHECK(over == 1);
        }
        const auto middle = ChartLookup(surface, chart).find({0, 0});
        REQUIRE(middle);
        CHECK(abs(position_in_space(surface, middle->at) - position_in_space(surface, anchor)) < 1e-9);
        double nearest = 0;
        for (const ChartTriangle& t : chart.triangles) {
            const double here = std::min({abs(t.at[0]), abs(t.at[1]), abs(t.at[2])});
            CHECK(here >= nearest - 1e-12);
            nearest = here;
        }
    }
}

TEST_CASE("on a sphere a chart is stretched across its rays by r / sin r") {
    const SurfaceMesh surface = surface_mesh(sphere_triangles(5));
    const SurfacePoint anchor = from_barycentric(surface, 4321, {0.4, 0.3, 0.3});
    const SurfaceChart chart = surface_chart(surface, anchor, {1, 0}, 1.6, {.stretch = 3});
    struct Sum {
        double areas = 0, stretched = 0;
    };
    std::map<int, Sum> rings;  // tenths of the radius; along the rays lengths are kept
    for (const ChartTriangle& triangle : chart.triangles) {
        const double r = abs(centre_of(triangle));
        Sum& ring = rings[static_cast<int>(10 * r)];
        const double area = area_of(surface.flat[static_cast<std::size_t>(triangle.face)]);
        ring.areas += area * r / std::sin(r);
        ring.stretched += area_of(triangle.at);
    }
    for (int tenths = 0; tenths < 15; ++tenths) {
        CAPTURE(tenths);
        CHECK(rings[tenths].stretched / rings[tenths].areas == Approx(1).epsilon(0.02));
    }
    // where r / sin r reaches a limit the good radius ends
    const SurfaceChart limited = surface_chart(surface, anchor, {1, 0}, 1.6, {.stretch = 1.25});
    CHECK(limited.good_radius > 0.95);
    CHECK(limited.good_radius < 1.15);  // 1.1311 / sin 1.1311 = 1.25
}

TEST_CASE("nothing flips and nothing is stretched too far within the good radius") {
    const SurfaceMesh surface = surface_mesh(torus_triangles(60, 30, 2, 0.7));
    PolarMapper mapper(surface);
    Random random(8);
    for (int i = 0; i < 40; ++i) {
        const SurfacePoint anchor = random_surface_point(surface, random);
        const SurfaceChart chart = surface_chart(mapper, anchor, {1, 0}, 3);
        CHECK(chart.good_radius > 0.4);
        CHECK(chart.good_radius < 0.7 * pi);  // half of the way round the tube
        for (const ChartTriangle& t : chart.triangles) {
            const ChartStretch stretch = stretch_of(surface, t);
            CHECK(stretch.smallest >= 1 / 1.5);
            CHECK(stretch.largest <= 1.5);
        }
        const ChartLookup lookup(surface, chart);
        for (int k = 0; k < 30; ++k) {
            const Complex place = polar(0.999 * chart.good_radius * std::sqrt(random.uniform()), random.uniform(-pi, pi));
            CHECK(lookup.find(place).has_value());
        }
    }
}

TEST_CASE("a chart knows how near a border is") {
    const SurfaceMesh surface = surface_mesh(plane_triangles(20, 20, 1));
    const SurfacePoint anchor = from_barycentric(surface, 2 * (20 * 3 + 10), {0.3, 0.4, 0.3});
    const double below = position_in_space(surface, anchor).y;
    const SurfaceChart reaching = surface_chart(surface, anchor, {1, 0}, 5),
                       inside = surface_chart(surface, anchor, {1, 0}, 2);
    CHECK(reaching.meets_border);
    CHECK(reaching.border_distance == Approx(below));
    CHECK_FALSE(inside.meets_border);
}
