#pragma once
// How much laid shapes cover each other on the surface.

#include <vector>

#include "geometry/box.h"
#include "growth/surface/laid_shape.h"
#include "growth/surface/sphere_grid.h"

namespace rinceau {

struct LaidOverlap {
    int other = 0;    ///< number of the shape that was added before
    double area = 0;  ///< in common, counted once for each pair of layers; no more than was asked for
};

/// Shapes laid so far, by the faces that they lie on.
class LaidOverlaps {
  public:
    /// Numbers rise from 0.
    int add(const LaidShape& shape);
    /// The shapes with area in common, by rising number; the count of an area ends at `enough`.
    std::vector<LaidOverlap> with(const LaidShape& shape, double enough) const;

  private:
    struct BoxedPiece {
        Box box;
        int first = 0, count = 0;
    };
    struct OnFace {
        int face = 0;
        Box box;
        std::vector<BoxedPiece> pieces;
    };
    struct Known {
        std::vector<OnFace> faces;  ///< by rising face
        std::vector<Point> corners;
    };
    static Known known_of(const LaidShape& shape);
    static double common_area(const Known& a, const Known& b, double enough);
    static double common_area(const Known& a, const OnFace& on_a, const Known& b, const OnFace& on_b, double enough);

    SphereGrid balls_;
    std::vector<Known> shapes_;
};

/// Area that two convex counter-clockwise polygons have in common.
double convex_common_area(const Point* a, int a_count, const Point* b, int b_count);

/// Have two convex polygons area in common once each is made `factor` times as large about its middle?
bool scaled_hulls_overlap(const std::vector<Point>& a, const std::vector<Point>& b, double factor);

}  // namespace rinceau
