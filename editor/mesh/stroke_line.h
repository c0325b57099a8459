#pragma once
// The lines that a pen follows: paths as polylines, cut into dashes.

#include <vector>

#include "scene/path.h"

namespace rinceau {

struct StrokePoint {
    Point at;
    bool smooth = false;  ///< within a curve: joined round, whatever the style's joins
};

/// Neighbouring points differ, the last and the first of a closed line too. A line of one point is a dot.
struct StrokeLine {
    std::vector<StrokePoint> points;
    bool closed = false;
    Point direction{1, 0};  ///< of a dot, length 1
};

/// The path as a line: curves within `deviation` (> 0), in their true directions at their ends; none for a path that is a
/// mere start.
std::vector<StrokeLine> stroke_lines(const Path& path, double deviation);

/// The parts of the line under the dashes, which begin `offset` before its start; the first and last dash of a closed line
/// are one if they meet. Lengths below 0, or all 0, leave the line whole, as do more than `max_dashes` dashes.
std::vector<StrokeLine> dashed(const StrokeLine& line, const std::vector<double>& dashes, double offset, int max_dashes);

}  // namespace rinceau
