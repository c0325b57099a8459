#pragma once
// Where ink may lie: regions as polygons, for the questions "inside?", "outside?", "do they overlap?".

#include <vector>

#include "scene/element.h"

namespace rinceau {

/// Polygons of the plane filled by the even-odd rule; their edges may touch but do not cross.
using Region = std::vector<std::vector<Point>>;

/// What `paths` enclose by the rule; curves within `deviation`.
Region enclosed_region(const std::vector<Path>& paths, FillRule rule, double deviation);

/// A region that holds all ink of an outline element (fill and stroke, dashes taken as solid), to within `deviation`.
Region painted_region(const Element& element, double deviation);

Region union_of(const Region& a, const Region& b);
Region intersection_of(const Region& a, const Region& b);
Region difference_of(const Region& a, const Region& b);
/// The region grown by `distance` on all sides, or shrunk if it is negative.
Region offset_region(const Region& region, double distance);

/// Area, holes taken off.
double area(const Region& region);
Box bounds(const Region& region);

}  // namespace rinceau
