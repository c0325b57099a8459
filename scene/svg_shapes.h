#pragma once
// The basic shapes as outlines (SVG 2, chapter 10), in the direction and from the start point that the standard gives
// them. User space, y DOWN. Arguments are resolved numbers in user units; shapes that are not to be drawn give no path.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/path.h"

namespace rinceau {

struct RectangleShape {
    double x = 0, y = 0, width = 0, height = 0;  ///< not drawn unless width and height > 0
    std::optional<double> rx, ry;                ///< nothing = auto: the other one, or 0; negative = auto
};
/// Corner radii are clamped to half the sides.
std::vector<Path> rectangle(const RectangleShape& shape);
/// Four cubic curves; not drawn unless both radii are > 0.
std::vector<Path> ellipse(Point center, double rx, double ry);
/// An open path, of length 0 if both ends are the same.
std::vector<Path> line(Point from, Point to);
/// `polyline`, or `polygon` if closed; a single point is a path of length 0, none gives no path.
std::vector<Path> polyline(std::span<const Point> points, bool closed);

/// The attribute `points`. Everything before a fault is kept; an odd last number is a fault.
struct ParsedPoints {
    std::vector<Point> points;
    bool faulty = false;
    std::size_t fault_at = 0;  ///< offset in the text
    std::string fault;
};
ParsedPoints parse_points(std::string_view text);

}  // namespace rinceau
