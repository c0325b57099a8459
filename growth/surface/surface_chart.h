#pragma once
// A patch of a surface laid flat by geodesic polar coordinates: drawings go through it onto the surface.

#include <array>
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
    double radius = 0;                     ///< every place nearer than this is mapped, unless a border is nearer
    std::vector<ChartTriangle> triangles;  ///< by rising distance of their nearest corner
    double good_radius = 0;                ///< largest within which no triangle flips or is stretched beyond `stretch`
    bool meets_border = false;             ///< within the radius
};

struct ChartOptions {
    double stretch = 1.5;  ///< singular values allowed in [1 / stretch, stretch]
};

/// `x` (length 1, in the frame of the anchor's face) becomes the chart's x axis.
SurfaceChart surface_chart(const SurfaceMesh& surface, SurfacePoint anchor, Complex x, double radius,
                           const ChartOptions& options = {});

/// Where a place of the chart lies on the surface, and the chart's x axis there (length 1, in the face's frame).
struct ChartPlace {
    SurfacePoint at;
    Complex x;
};
/// Nothing outside of the patch. Looks through a grid made on first use: see ChartLookup.
class ChartLookup {
  public:
    ChartLookup(const SurfaceMesh& surface, const SurfaceChart& chart);
    std::optional<ChartPlace> find(Complex place) const;

  private:
    const SurfaceMesh* surface_;
    const SurfaceChart* chart_;
    double cell_ = 1;
    int columns_ = 0;
    std::vector<std::size_t> first_;
    std::vector<int> list_;
};

}  // namespace rinceau
