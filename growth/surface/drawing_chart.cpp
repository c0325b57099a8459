#include "growth/surface/drawing_chart.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/box.h"
#include "geometry/index.h"

namespace rinceau {
namespace {

Box box_of(const ChartTriangle& triangle) {
    Box box;
    for (const Complex p : triangle.at) box = including(box, p);
    return box;
}

/// About as many cells as triangles.
void lay_grid(DrawingChart& chart) {
    Box all;
    double size = 0;
    for (const ChartTriangle& triangle : chart.triangles) {
        const Box box = box_of(triangle);
        all = including(all, box);
        size += std::max(width(box), height(box));
    }
    if (chart.triangles.empty()) return;
    const double count = static_cast<double>(chart.triangles.size());
    const double even = std::sqrt(std::max(width(all) * height(all), 1e-300) / count);
    chart.cell = std::max({size / count, even, 1e-6 * std::max(width(all), height(all)), 1e-300});
    chart.low = all.low;
    chart.columns = static_cast<int>(width(all) / chart.cell) + 1;
    chart.rows = static_cast<int>(height(all) / chart.cell) + 1;
    chart.first.assign(at(chart.columns * chart.rows) + 1, 0);
    const auto each_cell = [&](const ChartTriangle& triangle, auto&& visit) {
        const Box box = box_of(triangle);
        const auto column = [&](double x) {
            return std::min(static_cast<int>((x - chart.low.x) / chart.cell), chart.columns - 1);
        };
        const auto row = [&](double y) {
            return std::min(static_cast<int>((y - chart.low.y) / chart.cell), chart.rows - 1);
        };
        for (int y = row(box.low.y); y <= row(box.high.y); ++y)
            for (int x = column(box.low.x); x <= column(box.high.x); ++x) visit(at(y * chart.columns + x));
    };
    for (const ChartTriangle& triangle : chart.triangles)
        each_cell(triangle, [&](std::size_t cell) { ++chart.first[cell + 1]; });
    for (std::size_t k = 1; k < chart.first.size(); ++k) chart.first[k] += chart.first[k - 1];
    chart.list.resize(at(chart.first.back()));
    std::vector<int> next(chart.first.begin(), chart.first.end() - 1);
    for (std::size_t t = 0; t < chart.triangles.size(); ++t)
        each_cell(chart.triangles[t], [&](std::size_t cell) { chart.list[at(next[cell]++)] = static_cast<int>(t); });
}

/// The linear map from the chart to the face frame: columns.
struct Columns {
    Point x, y;
    double area = 0;  ///< of the chart's parallelogram
};
Columns to_face(const SurfaceMesh& surface, const ChartTriangle& triangle) {
    const auto& flat = surface.flat[at(triangle.face)];
    const Point u = triangle.at[1] - triangle.at[0], v = triangle.at[2] - triangle.at[0];
    const Point a = flat[1] - flat[0], b = flat[2] - flat[0];
    const double area = cross(u, v);
    return {(v.y * a - u.y * b) / area, (u.x * b - v.x * a) / area, area};
}

}  // namespace

double chart_stretch(const SurfaceMesh& surface, const ChartTriangle& triangle) {
    const Columns map = to_face(surface, triangle);
    if (!(map.area > 0)) return std::numeric_limits<double>::infinity();
    // singular values of a 2 x 2 matrix: half the sum and difference of two lengths
    const double sum = std::hypot(map.x.x + map.y.y, map.x.y - map.y.x),
                 difference = std::hypot(map.x.x - map.y.y, map.x.y + map.y.x);
    const double large = 0.5 * (sum + difference), small = 0.5 * std::abs(sum - difference);
    if (!(small > 0)) return std::numeric_limits<double>::infinity();
    return std::max(large, 1 / small);
}

DrawingChart drawing_chart(const SurfaceMesh& surface, std::vector<ChartTriangle> triangles) {
    DrawingChart chart;
    chart.triangles = std::move(triangles);
    chart.stretch.reserve(chart.triangles.size());
    for (const ChartTriangle& triangle : chart.triangles) chart.stretch.push_back(chart_stretch(surface, triangle));
    lay_grid(chart);
    return chart;
}

std::optional<ChartPlace> place_in_chart(const SurfaceMesh& surface, const DrawingChart& chart, Complex place) {
    std::optional<ChartPlace> found;
    ChartVisits visits;
    Box box;
    visit_chart(chart, including(box, place), visits, [&](int t) {
        if (found) return;
        const ChartTriangle& triangle = chart.triangles[at(t)];
        const Columns map = to_face(surface, triangle);
        if (!(map.area > 0)) return;
        const Point u = triangle.at[1] - triangle.at[0], v = triangle.at[2] - triangle.at[0], p = place - triangle.at[0];
        const double b1 = cross(p, v) / map.area, b2 = cross(u, p) / map.area, b0 = 1 - b1 - b2;
        constexpr double rounding = 1e-9;  // of a triangle's height
        if (b0 < -rounding || b1 < -rounding || b2 < -rounding) return;
        const double c1 = std::max(b1, 0.0), c2 = std::max(b2, 0.0), c0 = std::max(b0, 0.0), sum = c0 + c1 + c2;
        found = ChartPlace{from_barycentric(surface, triangle.face, {c0 / sum, c1 / sum, c2 / sum}), map.x / abs(map.x)};
    });
    return found;
}

PatchMaker::PatchMaker(const SurfaceMesh& surface) : surface_(&surface), mapper_(surface), taken_(at(surface.faces()), 0) {}

std::vector<ChartTriangle> PatchMaker::patch(SurfacePoint anchor, Complex x, double radius) {
    mapper_.map(anchor, radius);
    ++mark_;
    std::vector<ChartTriangle> triangles;
    const auto place = [&](int v) { return polar(mapper_.distance(v), mapper_.angle(v)) * conj(x); };
    const auto take = [&](int face) {
        if (taken_[at(face)] == mark_) return;
        const auto& corners = surface_->mesh.triangles[at(face)];
        for (const int v : corners)
            if (!mapper_.has(v)) return;
        taken_[at(face)] = mark_;
        triangles.push_back({face, {place(corners[0]), place(corners[1]), place(corners[2])}});
    };
    take(anchor.face);
    for (const int v : mapper_.reached()) {
        const int start = surface_->outgoing[at(v)];
        for (int h = start; h >= 0;) {
            take(face_of(h));
            h = next_about_start(*surface_, h);
            if (h == start) break;
        }
    }
    return triangles;
}

}  // namespace rinceau
