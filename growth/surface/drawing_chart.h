#pragma once
// A patch of a surface laid flat to draw on it, with what each triangle of it does to a drawing.

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/box.h"
#include "geometry/index.h"
#include "growth/surface/polar_map.h"
#include "growth/surface/surface_chart.h"

namespace rinceau {

/// Piecewise linear, in surface lengths. Triangles of a patch that is neither flipped nor laid over itself do not overlap.
struct DrawingChart {
    std::vector<ChartTriangle> triangles;
    /// By triangle: the largest of its singular values and their reciprocals, from the chart to the surface; infinite where
    /// the map is flipped or without area.
    std::vector<double> stretch;
    // a grid over the triangles' boxes
    Point low;
    double cell = 1;
    int columns = 0, rows = 0;
    std::vector<int> first, list;
};

/// `triangles` may be in any order.
DrawingChart drawing_chart(const SurfaceMesh& surface, std::vector<ChartTriangle> triangles);

/// Stretch of one triangle, as above.
double chart_stretch(const SurfaceMesh& surface, const ChartTriangle& triangle);

/// Calls visit(index) once for each triangle whose box may meet `box`; `seen` and `mark` tell which were visited.
struct ChartVisits {
    std::vector<std::uint32_t> seen;
    std::uint32_t mark = 0;
};
template <class Visit>
void visit_chart(const DrawingChart& chart, const Box& box, ChartVisits& visits, Visit&& visit) {
    if (chart.columns == 0) return;
    if (visits.seen.size() < chart.triangles.size()) visits.seen.resize(chart.triangles.size(), 0);
    ++visits.mark;
    const auto clamped = [&](double value, double low, int count) {
        return static_cast<int>(std::clamp((value - low) / chart.cell, 0.0, static_cast<double>(count - 1)));
    };
    const int x0 = clamped(box.low.x, chart.low.x, chart.columns), x1 = clamped(box.high.x, chart.low.x, chart.columns);
    const int y0 = clamped(box.low.y, chart.low.y, chart.rows), y1 = clamped(box.high.y, chart.low.y, chart.rows);
    for (int y = y0; y <= y1; ++y)
        for (int x = x0; x <= x1; ++x) {
            const std::size_t at = table_index(y, x, chart.columns);
            for (int k = chart.first[at]; k < chart.first[at + 1]; ++k) {
                const int t = chart.list[static_cast<std::size_t>(k)];
                std::uint32_t& seen = visits.seen[static_cast<std::size_t>(t)];
                if (seen == visits.mark) continue;
                seen = visits.mark;
                visit(t);
            }
        }
}

/// Where a place of the chart lies on the surface, and the chart's x axis there. Nothing outside of the patch.
std::optional<ChartPlace> place_in_chart(const SurfaceMesh& surface, const DrawingChart& chart, Complex place);

/// Faces about a place, laid flat by geodesic polar coordinates: the place at the origin, `x` (length 1, in the frame of its
/// face) as x axis. All faces within the radius.
class PatchMaker {
  public:
    explicit PatchMaker(const SurfaceMesh& surface);
    std::vector<ChartTriangle> patch(SurfacePoint anchor, Complex x, double radius);

  private:
    const SurfaceMesh* surface_;
    PolarMapper mapper_;
    std::vector<std::uint32_t> taken_;  ///< by face
    std::uint32_t mark_ = 0;
};

}  // namespace rinceau
