#pragma once
// Contours in two halves.

#include <vector>

#include "geometry/point.h"

namespace rinceau {

/// Corners in order, the last joined to the first.
using Contours = std::vector<std::vector<Point>>;

enum class Axis : unsigned char { x, y };

constexpr double along(Axis axis, Point p) { return axis == Axis::x ? p.x : p.y; }

struct CutContours {
    Contours low;
    Contours high;
};

/// What lies below and above the line on which the coordinate `axis` is `at`. Winding numbers on either side stay as they
/// are: contours are closed along the line. Points that are put onto the line lie on it exactly, and alike in both halves.
CutContours cut(const Contours& contours, Axis axis, double at);

std::size_t corner_count(const Contours& contours);

}  // namespace rinceau
