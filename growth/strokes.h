#pragma once
// Lines and areas that a person draws to guide growth, read from a drawing: flow strokes, boundary lines, regions.

#include <string>
#include <vector>

#include "scene/element.h"
#include "scene/painted_region.h"

namespace rinceau {

/// A line as it was drawn: its corners in order. At least two, none equal to the one before. A closed outline ends where it
/// begins.
using Polyline = std::vector<Point>;

/// Every sub-path of every shape as a line to within `deviation` (a scene length), in paint order. What is kept as SVG text
/// is left out.
std::vector<Polyline> polylines_of(const Scene& scene, double deviation);

double length_of(const Polyline& line);

/// The points that cut the line into `count` > 0 arcs of equal length, its ends among them.
std::vector<Point> cut_evenly(const Polyline& line, std::size_t count);

/// What the drawing's closed outlines enclose by the even-odd rule all together, so that an outline inside another one is a
/// hole; fills and strokes play no part. Throws InputError in the name of `label` if no outline is closed or nothing is
/// enclosed, or if an outline crosses itself or another one: it says where.
Region region_of(const Scene& scene, double deviation, const std::string& label);

}  // namespace rinceau
