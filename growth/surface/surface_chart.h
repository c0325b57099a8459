#pragma once
// A patch of a surface laid flat by geodesic polar coordinates: drawings go through it onto the surface.

#include <array>
#include <limits>
#include <optional>
#include <vector>

#include "growth/surface/polar_map.h"

namespace rinceau {

struct ChartTriangle {
    int face = 0;
    std::array<Complex, 3> at;  ///< places of its corners in the chart
};

/// A piecewise-linear map between a patch about `anchor` and the plane; the anchor is at the origin.
struct SurfaceChart {
    SurfacePoint anchor;
    /// Every place of the surface nearer than this is mapped, but for triangles that flip or are stretched too far: those
    /// are left out, and none lies within good_radius.
    double radius = 0;
    std::vector<ChartTriangle> triangles;  ///< by rising distance of their nearest corner
    double good_radius = 0;                ///< largest within which no triangle flips or is stretched beyond `stretch`
    bool meets_border = false;             ///< within the radius
    double border_distance = std::numeric_limits<double>::infinity();  ///< in the chart, of borders that were reached
};

struct ChartOptions {
    double stretch = 1.5;  ///< singular values allowed in [1 / stretch, stretch]
};

/// `x` (length 1, in the frame of the anchor's face) becomes the chart's x axis.
SurfaceChart surface_chart(const SurfaceMesh& surface, SurfacePoint anchor, Complex x, double radius,
                           const ChartOptions& options = {});
/// The same, for many charts of one surface: costs only what lies within the radius.
SurfaceChart surface_chart(PolarMapper& mapper, SurfacePoint anchor, Complex x, double radius,
                           const ChartOptions& options = {});

/// How the flat face is stretched on its way into the chart.
struct ChartStretch {
    double largest = 1, smallest = 1;  ///< singular values; smallest is negative where the face is flipped
};
ChartStretch stretch_of(const SurfaceMesh& surface, const ChartTriangle& triangle);

/// Where a place of the chart lies on the surface, and the chart's x axis there (length 1, in the face's frame).
struct ChartPlace {
    SurfacePoint at;
    Complex x;
};

/// Finds places in a chart through a grid over its triangles. Refers to both, which must outlive it.
class ChartLookup {
  public:
    ChartLookup(const SurfaceMesh& surface, const SurfaceChart& chart);
    /// Nothing outside of the patch. On an edge either of its faces.
    std::optional<ChartPlace> find(Complex place) const;

  private:
    int cell_of(double coordinate) const;

    const SurfaceMesh* surface_;
    const SurfaceChart* chart_;
    double cell_ = 1;
    double low_ = 0;  ///< of both coordinates
    int columns_ = 0;
    std::vector<std::size_t> first_;  ///< by cell, row by row, into list_; one more at the end
    std::vector<int> list_;           ///< of triangles
};

}  // namespace rinceau
