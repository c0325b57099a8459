#pragma once
// The scope of a shape: where it stands on the surface, how it is turned, how large it is (Li et al. 2010, section 3.1).

#include <array>
#include <map>
#include <memory>
#include <string>

#include "growth/surface/surface_point.h"

namespace rinceau {

struct ScopeChart;  // shape_moves.h

/// A value: brackets and symbols take copies.
struct ShapeScope {
    SurfacePoint at;
    Complex x{1, 0};                         ///< X as long as nothing is tilted, of length 1, in the frame of at's face
    double offset = 0;                       ///< of the position from the surface, along its normal
    std::array<double, 4> tilt{0, 0, 0, 1};  ///< turns (X, N x X, N) into the scope's axes: a unit quaternion x, y, z, w
    bool tilted = false;
    SpacePoint size{1, 1, 1};
    std::shared_ptr<const Color> color;  ///< none: the shape's own
    std::shared_ptr<const std::map<std::string, double>> attributes;
    int kin = -1;   ///< the last of its ancestors, see ShapeKin
    int line = -1;  ///< that LineSeg goes on with; -1 = it begins one
    bool line_merges = false;
    int line_points = 0;                 ///< of that line when the scope stood at its end
    std::shared_ptr<ScopeChart> chart;   ///< moves go through it
    Complex chart_place, chart_x{1, 0};  ///< in the chart: the scope's place and its X, of length 1
};

/// The scope's axes in space, of length 1 and right-handed; the third is the surface's normal unless it is tilted.
struct ScopeFrame {
    SpacePoint position;
    std::array<SpacePoint, 3> axes;
    SpacePoint normal;  ///< of the surface
    double lift = 0;    ///< of the position above the surface
};
ScopeFrame frame_in_space(const SurfaceMesh& surface, const ShapeScope& scope);

/// Degrees about the scope's own axes, counter-clockwise seen from the axis' tip.
void turn_about_x(ShapeScope& scope, double degrees);
void turn_about_y(ShapeScope& scope, double degrees);
/// Turns X in the surface unless the scope is tilted.
void turn_about_z(ShapeScope& scope, double degrees);

/// The placed shapes that a scope comes from, for all scopes of a derivation: each refers to the one before it.
struct ShapeKin {
    struct Link {
        int placed = 0;  ///< number of the shape
        int before = -1;
    };
    std::vector<Link> links;

    /// A new last link behind `kin`; gives its index.
    int with(int kin, int placed);
    /// The last `count` placed shapes, the nearest first.
    std::vector<int> last(int kin, int count) const;
};

}  // namespace rinceau
