#pragma once
// A field of directions in the plane, interpolated between strokes by radial basis functions (Ijiri et al. 2008, section 3).

#include <span>
#include <string>
#include <vector>

#include "geometry/box.h"
#include "geometry/point.h"
#include "growth/strokes.h"

namespace rinceau {

struct FlowOptions {
    double step = 1;                    ///< of the table, scene length; half an edge of the exemplar is fine enough
    bool directed = true;               ///< strokes say forward and back; false: only along which line (doubled angles)
    std::size_t max_samples = 300;      ///< of all strokes together
    std::size_t max_cells = 4'000'000;  ///< the step is widened to keep within
};

/// Directions on a grid; a value, cheap to copy where it is shared.
struct FlowField {
    Box box;  ///< where it was tabulated; outside, the nearest edge counts
    double step = 1;
    int columns = 0, rows = 0;
    bool directed = true;
    std::vector<Complex> table;  ///< unit vectors, row by row from the low edge; of an undirected field their squares
};

/// Where no direction can be told (a singular point on a node of the table, opposite strokes) the table holds the direction
/// of its neighbourhood's larger part. On the strokes the field follows them to within about a degree; far from them it goes
/// on as they do. Throws InputError in the name of `label` if no stroke has a length. The box is not empty.
FlowField make_flow_field(std::span<const Polyline> strokes, const Box& box, const FlowOptions& options,
                          const std::string& label);

/// Unit vector along the flow. Continuous but at singular points; of an undirected field the one of two that lies within 90
/// degrees of +x.
Complex direction_at(const FlowField& field, Point p);

/// Where the field turns about: half turns counter-clockwise of the direction around the cell (2 = one full turn).
struct SingularPoint {
    Point at;
    int half_turns = 0;
};
/// One for each cell of the table that has one; `at` is the cell's middle.
std::vector<SingularPoint> singular_points(const FlowField& field);

}  // namespace rinceau
