#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include "geometry/angle.h"
#include "growth/surface/dash_lines.h"
#include "growth/surface/laid_meshes.h"
#include "growth/surface/laid_overlaps.h"
#include "growth/surface/lay_triangles.h"
#include "growth/surface/relax_chart.h"
#include "growth/surface/terminal_art.h"
#include "tests/surface/surface_shapes.h"

using namespace rinceau;

namespace {

double piece_area(const LaidPieces& laid, const LaidPiece& piece) {
    double doubled = 0;
    const Point* p = &laid.corners[static_cast<std::size_t>(piece.first)];
    for (int k = 1; k + 1 < piece.count; ++k) doubled += cross(p[k] - p[0], p[k + 1] - p[0]);
    return 0.5 * doubled;
}

std::map<int, double> area_by_face(const LaidPieces& laid) {
    std::map<int, double> areas;
    for (const LaidPiece& piece : laid.pieces) areas[piece.face] += piece_area(laid, piece);
    return areas;
}

struct Rectangle {
    std::vector<Point> points;
    std::vector<std::array<int, 3>> triangles{{0, 1, 2}, {0, 2, 3}};
    double area = 0;
    LayingTriangles laying() const { return {points, triangles, area}; }
};
Rectangle rectangle(Point low, Point high) {
    return {{low, {high.x, low.y}, high, {low.x, high.y}}, {{0, 1, 2}, {0, 2, 3}}, (high.x - low.x) * (high.y - low.y)};
}

SurfacePoint middle_of_face(const SurfaceMesh& surface, int face) {
    return from_barycentric(surface, face, {0.2, 0.3, 0.5});
}

double worst_within(const DrawingChart& chart, double radius) {
    double worst = 1;
    for (std::size_t t = 0; t < chart.triangles.size(); ++t) {
        bool inside = true;
        for (const Complex p : chart.triangles[t].at) inside = inside && abs(p) < radius;
        if (inside) worst = std::max(worst, chart.stretch[t]);
    }
    return worst;
}

}  // namespace

TEST_CASE("Neighbours with a common edge leave no gap and no overlap in a chart: together they are the whole") {
    const SurfaceMesh sphere = surface_mesh(sphere_triangles(3));
    PatchMaker patches(sphere);
    const DrawingChart chart = drawing_chart(sphere, patches.patch(middle_of_face(sphere, 17), {1, 0}, 0.8));
    ChartVisits visits;
    LaidPieces both, whole;
    const Rectangle left = rectangle({-0.4, -0.3}, {0.05, 0.3}), right = rectangle({0.05, -0.3}, {0.4, 0.3});
    REQUIRE(lay_triangles(sphere, chart, left.laying(), {1.5}, visits, both) == LayFault::none);
    REQUIRE(lay_triangles(sphere, chart, right.laying(), {1.5}, visits, both) == LayFault::none);
    REQUIRE(lay_triangles(sphere, chart, rectangle({-0.4, -0.3}, {0.4, 0.3}).laying(), {1.5}, visits, whole) ==
            LayFault::none);
    const std::map<int, double> a = area_by_face(both), b = area_by_face(whole);
    REQUIRE(a.size() == b.size());
    for (const auto& [face, area] : b) CHECK(a.at(face) == Approx(area).margin(1e-12));
}

TEST_CASE("A shape beyond the patch, or on a stretched or flipped triangle, is not laid at all") {
    const SurfaceMesh sphere = surface_mesh(sphere_triangles(3));
    PatchMaker patches(sphere);
    DrawingChart chart = drawing_chart(sphere, patches.patch(middle_of_face(sphere, 3), {1, 0}, 0.5));
    ChartVisits visits;
    LaidPieces laid;
    CHECK(lay_triangles(sphere, chart, rectangle({-0.2, -0.2}, {2, 0.2}).laying(), {3}, visits, laid) == LayFault::outside);
    CHECK(lay_triangles(sphere, chart, rectangle({-0.3, -0.3}, {0.3, 0.3}).laying(), {1.0001}, visits, laid) ==
          LayFault::stretched);
    std::swap(chart.triangles[0].at[0], chart.triangles[0].at[1]);
    CHECK(lay_triangles(sphere, chart, rectangle({-0.3, -0.3}, {0.3, 0.3}).laying(), {3}, visits, laid) == LayFault::folded);
    CHECK(laid.pieces.empty());
    CHECK(laid.corners.empty());
}

TEST_CASE("Relaxing shares the stretch of a polar chart out, keeps its middle, and leaves a plane as it is") {
    const SurfaceMesh sphere = surface_mesh(sphere_triangles(4));
    PatchMaker patches(sphere);
    const std::vector<ChartTriangle> polar_patch = patches.patch(middle_of_face(sphere, 100), {0.6, 0.8}, 1.2);
    const std::vector<ChartTriangle> relaxed = relaxed_chart(sphere, polar_patch, 12);
    const double before = worst_within(drawing_chart(sphere, polar_patch), 1.0);
    const double after = worst_within(drawing_chart(sphere, relaxed), 1.0);
    CHECK(before == Approx(1 / std::sin(1.0)).epsilon(0.05));  // r / sin r
    CHECK(after - 1 < 0.7 * (before - 1));
    const auto place = place_in_chart(sphere, drawing_chart(sphere, relaxed), {0, 0});
    REQUIRE(place);
    CHECK(place->at.face == 100);
    CHECK(abs(place->at.at - middle_of_face(sphere, 100).at) < 1e-9);
    CHECK(abs(place->x - Complex{0.6, 0.8}) < 1e-6);

    const SurfaceMesh plane = surface_mesh(plane_triangles(12, 12, 1, 0.3));
    PatchMaker flat_patches(plane);
    const DrawingChart flat =
        drawing_chart(plane, relaxed_chart(plane, flat_patches.patch(middle_of_face(plane, 150), {1, 0}, 4), 12));
    CHECK(worst_within(flat, 4) - 1 < 1e-7);
}

TEST_CASE("A chart bent along a field shows the field straight, without a fold") {
    const SurfaceMesh plane = surface_mesh(plane_triangles(30, 30, 0.1, 0.3));
    SurfaceField turning;
    turning.n = 2;
    turning.exact = PlaneForm{true, {-2, 1.5}, pi / 2};  // circles about a place outside
    const FieldOnSurface field(plane, turning);
    PatchMaker patches(plane);
    const SurfacePoint middle = middle_of_face(plane, 915);
    const std::vector<ChartTriangle> flat = patches.patch(middle, {1, 0}, 0.8);
    /// Root mean square of the angle between the field in the chart and what it is at the middle.
    const auto off = [&](const std::vector<ChartTriangle>& chart) {
        double first = 0, sum = 0;
        for (const bool measures : {false, true})
            for (const ChartTriangle& triangle : chart) {
                if ((triangle.face == middle.face) == measures) continue;
                const SurfacePoint p = middle_of_face(plane, triangle.face);
                const auto& corners = plane.flat[static_cast<std::size_t>(triangle.face)];
                const Complex turn = (triangle.at[1] - triangle.at[0]) * conj(corners[1] - corners[0]) +
                                     (triangle.at[2] - triangle.at[1]) * conj(corners[2] - corners[1]);
                const double angle = arg(field.at(p)) + 2 * arg(turn);
                if (!measures) first = angle;
                sum += measures ? std::pow(wrap_angle(angle - first), 2) : 0;
            }
        return std::sqrt(sum / static_cast<double>(chart.size()));
    };
    const std::vector<ChartTriangle> bent = bent_chart(field, 1, flat);
    CHECK(off(flat) > 0.2);
    CHECK(off(bent) < 0.5 * off(flat));
    CHECK(worst_within(drawing_chart(plane, bent), 0.7) < 2);
    CHECK(worst_within(drawing_chart(plane, bent_chart(field, 0, flat)), 0.7) - 1 < 1e-6);
}

TEST_CASE("Each shape is painted above those that it covers, and only those") {
    CHECK(paint_ranks({0, 1, 2, 3}, {{}, {0, 2}, {1}, {}}) == std::vector<int>{0, 1, 2, 0});
    // painted in another order than derived
    CHECK(paint_ranks({2, 1, 0}, {{1}, {0, 2}, {1}}) == std::vector<int>{2, 1, 0});
}

TEST_CASE("Convex polygons have the area in common that they have") {
    const std::vector<Point> square{{0, 0}, {2, 0}, {2, 2}, {0, 2}}, diamond{{1, 0}, {2, 1}, {1, 2}, {0, 1}};
    CHECK(convex_common_area(square.data(), 4, diamond.data(), 4) == Approx(2));
    const std::vector<Point> beside{{2, 0}, {3, 0}, {3, 1}, {2, 1}};
    CHECK(convex_common_area(square.data(), 4, beside.data(), 4) == 0);
    CHECK(scaled_hulls_overlap(square, beside, 1.1));
    CHECK_FALSE(scaled_hulls_overlap(square, beside, 0.9));
}

TEST_CASE("A line is cut into its dashes, from where the pattern begins") {
    Stroke stroke;
    stroke.dashes = {2, 1};
    stroke.dash_offset = 1;
    const std::vector<Path> dashes = dash_lines({{{0, 0}, {line_to({4, 0}), line_to({4, 4})}, false}}, stroke, 0.01);
    REQUIRE(dashes.size() == 3);
    CHECK(length(dashes) == Approx(1 + 2 + 2));
    CHECK(dashes[0].start == Point{0, 0});
    CHECK(dashes[1].start == Point{2, 0});
    CHECK(dashes[2].segments.back().to == Point{4, 3});
    stroke.dashes.clear();
    CHECK(dash_lines({{{0, 0}, {line_to({4, 0})}, false}}, stroke, 0.01).size() == 1);
}

TEST_CASE("A gradient's mean colour weighs each stop by its share and its opacity") {
    Gradient gradient;
    gradient.stops = {{0, {0, 0, 0}, 1}, {1, {200, 100, 50}, 1}};
    CHECK(mean_color(gradient) == Color{100, 50, 25});
    gradient.stops = {{0.5, {0, 0, 0}, 1}, {0.5, {200, 100, 50}, 1}};
    CHECK(mean_color(gradient) == Color{100, 50, 25});
    gradient.stops = {{0, {0, 0, 0}, 0}, {1, {200, 100, 50}, 1}};
    CHECK(mean_color(gradient) == Color{200, 100, 50});
}
