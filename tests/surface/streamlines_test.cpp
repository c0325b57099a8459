#include "growth/surface/streamlines.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "growth/surface/closed_streamline.h"
#include "surface_directions.h"
#include "surface_shapes.h"

using namespace rinceau;

namespace {

DirectionAndNormal round_torus(SpacePoint p, double large, double angle) {
    const SpacePoint around = unit(SpacePoint{-p.y, p.x, 0}), out = unit(SpacePoint{p.x, p.y, 0});
    const SpacePoint normal = unit(p - large * out), meridian = cross(normal, around);
    return {std::cos(angle) * around + std::sin(angle) * meridian, normal};
}

SpacePoint middle_of(const SurfaceMesh& surface, const Streamline& line) {
    return position_in_space(surface, line.path[line.path.size() / 2]);
}

}  // namespace

TEST_CASE("streamlines of a constant field are parallel lines a spacing apart that leave no gap") {
    const SurfaceMesh surface = surface_mesh(plane_triangles(20, 20, 1, 0.2));
    const FieldOnSurface field(surface, {.n = 2, .exact = PlaneForm{.angle = 0}});
    const Streamlines drawn = streamlines(field, {.spacing = 0.8});
    CHECK(drawn.complete);
    std::vector<double> heights;
    for (const Streamline& line : drawn.lines) {
        CHECK_FALSE(line.closed);
        heights.push_back(middle_of(surface, line).y);
        // from side to side at one height
        for (const SurfacePoint p : line.path) CHECK(position_in_space(surface, p).y == Approx(heights.back()));
        CHECK(position_in_space(surface, line.path.front()).x * (20 - position_in_space(surface, line.path.back()).x) ==
              Approx(0).margin(1e-9));
    }
    std::ranges::sort(heights);
    REQUIRE(heights.size() > 20);
    CHECK(heights.front() < 0.81);
    CHECK(heights.back() > 19.19);
    for (std::size_t i = 1; i < heights.size(); ++i) {
        CHECK(heights[i] - heights[i - 1] > 0.98 * 0.8);
        CHECK(heights[i] - heights[i - 1] < 2 * 0.8);
    }
}

TEST_CASE("lines around a torus close, and minor lines cross them") {
    const SurfaceMesh surface = surface_mesh(torus_triangles(60, 40, 2, 0.7));
    const FieldOnSurface field(surface, field_of_directions(surface, 2, [](SpacePoint p) { return round_torus(p, 2, 0); }));
    const Streamlines drawn = streamlines(field, {.spacing = 0.2, .minor = true});
    int closed = 0, major = 0;
    for (const Streamline& line : drawn.lines) {
        closed += line.closed;
        major += !line.minor;
        if (!line.closed || line.minor) continue;
        const double height = position_in_space(surface, line.path.front()).z;
        for (const SurfacePoint p : line.path) CHECK(position_in_space(surface, p).z == Approx(height).margin(0.03));
    }
    CHECK(major >= 15);  // 2 pi 0.7 / 0.2 = 22 lines fit
    CHECK(major <= 23);
    CHECK(closed >= major);
    CHECK(static_cast<int>(drawn.lines.size()) > 2 * major);
}

TEST_CASE("streamlines keep their distance and reach everywhere on a sphere, whatever the symmetry of the field") {
    const SurfaceMesh surface = surface_mesh(sphere_triangles(3));
    const double spacing = 0.2;
    for (const int n : {1, 2, 4}) {
        const FieldOnSurface field(surface, field_of_directions(surface, n, [](SpacePoint p) {
                                       const SpacePoint away{std::sin(2 * p.y) + 0.3, std::cos(p.z + p.x), std::sin(p.x)};
                                       return DirectionAndNormal{unit(away - dot(away, p) * p), p};
                                   }));
        const Streamlines drawn = streamlines(field, {.spacing = spacing});
        std::vector<SpacePoint> points;
        for (const Streamline& line : drawn.lines)
            for (const SurfacePoint p : line.path) points.push_back(position_in_space(surface, p));
        Random random(4);
        int empty = 0;
        const int places = 300;
        for (int i = 0; i < places; ++i) {
            const SpacePoint p = position_in_space(surface, random_surface_point(surface, random));
            const double nearest = abs(*std::ranges::min_element(points, {}, [&](SpacePoint q) { return abs(q - p); }) - p);
            empty += nearest > 1.2 * spacing;
        }
        CHECK(empty <= places / 50);
        const Streamlines again = streamlines(field, {.spacing = spacing});
        REQUIRE(again.lines.size() == drawn.lines.size());
        CHECK(again.lines.back().path.back().at == drawn.lines.back().path.back().at);
    }
}

TEST_CASE("a row round a cylinder closes with equal steps") {
    const SurfaceMesh surface = surface_mesh(cylinder_triangles(40, 20, 1, 2));
    const double total = 80 * std::sin(pi / 40);
    const SurfacePoint start = from_barycentric(surface, 2 * (10 * 40 + 3), {0.3, 0.4, 0.3});
    for (const double step : {0.1, 0.37, 1.0, 2.5}) {
        const auto row = closed_row(surface, nullptr, start, {1, 0}, step);
        REQUIRE(row);
        CHECK(row->length == Approx(total).epsilon(1e-9));
        CHECK(row->gap == Approx(0).margin(1e-9));
        CHECK(row->places.size() == static_cast<std::size_t>(std::lround(total / step)));
        CHECK(row->step == Approx(total / static_cast<double>(row->places.size())));
        const SurfaceTrace last = trace(surface, nullptr, row->places.back().at, row->places.back().direction, row->step);
        CHECK(abs(position_in_space(surface, last.end) - position_in_space(surface, start)) < 1e-9);
    }
    // a helix comes back beside its start: too far
    CHECK_FALSE(closed_row(surface, nullptr, start, polar(1, 0.1), 0.3));
}

TEST_CASE("a row round a torus closes on its field line, a dense winding does not") {
    const SurfaceMesh surface = surface_mesh(torus_triangles(90, 40, 2, 0.7));
    const FieldOnSurface field(surface, field_of_directions(surface, 2, [](SpacePoint p) { return round_torus(p, 2, 0); }));
    Random random(6);
    for (int i = 0; i < 10; ++i) {
        const SurfacePoint start = random_surface_point(surface, random);
        const SpacePoint place = position_in_space(surface, start);
        const double radius = std::hypot(place.x, place.y);
        const Complex around = root_near(field.at(start), 2, {1, 0});
        const auto row = closed_row(surface, &field, start, around, 0.3);
        REQUIRE(row);
        CHECK(row->length == Approx(two_pi * radius).epsilon(0.01));
        CHECK(std::abs(row->gap) < 0.02);
        CHECK(row->places.size() == static_cast<std::size_t>(std::lround(row->length / 0.3)));
        // all steps alike in space, also from the last place to the first
        for (std::size_t k = 0; k < row->places.size(); ++k) {
            const SpacePoint a = position_in_space(surface, row->places[k].at);
            const SpacePoint b = position_in_space(surface, row->places[(k + 1) % row->places.size()].at);
            CHECK(abs(b - a) == Approx(2 * radius * std::sin(row->step / radius / 2)).epsilon(0.02));
        }
        const auto across = closed_row(surface, &field, start, around * Complex{0, 1}, 0.3);
        REQUIRE(across);
        CHECK(across->length == Approx(two_pi * 0.7).epsilon(0.01));
        CHECK_FALSE(closed_row(surface, &field, start, around * polar(1, 0.6), 0.02, {.longest = 60}));
    }
}
