#pragma once
// Rows of elements that close: on field lines that come back to their start.

#include <optional>
#include <vector>

#include "growth/surface/trace.h"

namespace rinceau {

struct ClosedRowOptions {
    double nearest = 0.5;        ///< of the step: the line closes if it comes back to its start so near
    double turn = 5;             ///< degrees by which its direction may differ there
    double longest = 0;          ///< surface length after which it counts as open; 0 = ten times the surface's diagonal
    int max_elements = 100'000;  ///< a row of more counts as open
};

/// A place of a row and the row's direction there (length 1, in the frame of the face).
struct RowPlace {
    SurfacePoint at;
    Complex direction;
};

struct ClosedRow {
    double length = 0;             ///< of the closed line
    double gap = 0;                ///< by which the line missed its start, sideways, to the left; shared out over the row
    double step = 0;               ///< length / number of places
    std::vector<RowPlace> places;  ///< the first is the start
};

/// Does the line through `start` in `direction` (length 1), at a constant angle to the field or straight without one, come
/// back to its start? Then it is cut into the whole number of equal steps that is nearest to `step` (> 0), at least one.
/// Nothing for an open line.
std::optional<ClosedRow> closed_row(const SurfaceMesh& surface, const FieldOnSurface* field, SurfacePoint start,
                                    Complex direction, double step, const ClosedRowOptions& options = {});

}  // namespace rinceau
