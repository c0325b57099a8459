#pragma once
// Moving over a surface: along a field at a constant angle, or straight (Li et al. 2010, section 4.3.1).

#include <vector>

#include "growth/surface/surface_field.h"

namespace rinceau {

struct TraceOptions {
    double step = 0.5;   ///< largest, of the surface's longest edge
    double turn = 2.5;   ///< degrees that the field may turn in half a step before the step is halved
    double jump = 0.02;  ///< nearness to a singular point at which the walk jumps over it, of the longest edge; 0 = never
    double follow =
        1;  ///< 1 = at a constant angle to the field, 0 = straight; between: turned by that share of the field's turn
    bool keep_path = false;  ///< fill SurfaceTrace::path
};

/// The end of a walk.
struct SurfaceTrace {
    SurfacePoint end;
    Complex direction;       ///< at the end, of length 1, in the frame of end's face
    double length = 0;       ///< walked
    bool at_border = false;  ///< it ended at the surface's border
    int jumps = 0;           ///< over singular points: the angle to the field has changed there
    /// Radians: how far a straight piece of the walk deviates from its angle to the field, that taken in the middle between
    /// the field's directions at both ends of the piece. The largest of all pieces, but for jumps.
    double angle_error = 0;
    double angle_error_sum = 0;  ///< over angle_samples pieces
    long angle_samples = 0;
    std::vector<SurfacePoint> path;  ///< start, a point wherever it bends or crosses an edge (behind the edge), end
};

/// Walks `length` (>= 0) from `start` in `direction` (length 1, in the frame of start's face). With a field the angle
/// between the walk and the field stays what it is at the start, without one the way is straight: faces unfold. The end lies
/// in its face; the length is exact unless a border is met. The sign of an eigenvector is resolved along the way, never by a
/// jump. Work is bounded: a walk that makes no way any more ends early, `length` says where.
SurfaceTrace trace(const SurfaceMesh& surface, const FieldOnSurface* field, SurfacePoint start, Complex direction,
                   double length, const TraceOptions& options = {});

/// Turns `direction` at `from` into what it is at the end of `walk`, keeping its angle to the walk.
inline Complex carried(Complex direction, Complex walk_at_start, const SurfaceTrace& walk) {
    return direction * conj(walk_at_start) * walk.direction;
}

}  // namespace rinceau
