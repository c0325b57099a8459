#pragma once
// Path data: the attribute `d` (SVG 1.1, section 8.3; SVG 2, section 9.3).

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/path.h"

namespace rinceau {

/// Beyond this no renderer draws anything sensible, and neighbouring coordinates have lost the digits that tell them apart;
/// sums of squares stay finite below it.
constexpr double largest_coordinate = 1e15;

/// Sub-paths in SVG's user space (y DOWN), arcs and quadratic curves as cubics. Everything before a fault is kept.
/// Sub-paths that have a moveto only are left out; "M1 1z", "M1 1h0" are kept (round and square caps make them dots):
/// closed without segments, or open with segments of length 0.
struct ParsedPath {
    std::vector<Path> paths;
    /// Ends of segments inside an arc command, where the drawing has no vertex: (sub-path, segment), rising.
    std::vector<std::pair<std::size_t, std::size_t>> arc_joints;
    bool faulty = false;
    std::size_t fault_at = 0;  ///< offset in the text
    std::string fault;         ///< what was expected there
};

/// Faults: anything outside the grammar, data that do not start with a moveto, coordinates (also of control points that are
/// implied) and other numbers beyond largest_coordinate.
ParsedPath parse_path_data(std::string_view text);

}  // namespace rinceau
