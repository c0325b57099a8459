#pragma once
// The outlines of the shape elements: path, rect, circle, ellipse, line, polyline, polygon.

#include <string_view>
#include <vector>

#include "scene/path.h"
#include "scene/svg_reader.h"

namespace rinceau {

bool is_shape(std::string_view element_name);
/// Shapes that markers apply to: path, line, polyline, polygon.
bool takes_markers(std::string_view element_name);

/// A length of an element, from a CSS property of that name or else from the attribute; `fallback` if it is missing, not
/// understood, or a keyword.
double length_of(const SvgContext& context, std::string_view name, LengthAxis axis, double fallback);

/// In user space (y down). Faults in the data are reported; what comes before them is kept. Empty if nothing is drawn.
std::vector<Path> outline_of(SvgReader& reader, const SvgContext& context);

/// Is every coordinate a number up to largest_coordinate (svg_path_data.h)?
bool is_in_range(const std::vector<Path>& paths);

/// Which ends of segments of that outline, (sub-path, segment), are no vertices of the drawing but joints inside an arc.
std::vector<std::pair<std::size_t, std::size_t>> arc_joints_of(const SvgContext& context);

}  // namespace rinceau
