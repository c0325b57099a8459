#pragma once
// pathLength: dashes counted in a length of the author's own (SVG 2, "The pathLength attribute").

#include <optional>
#include <string_view>

#include "scene/svg_reader.h"

namespace rinceau {

/// One number that is not below 0.
std::optional<double> parse_path_length(std::string_view text);

/// The style with dashes in user units: a dash of d is the part d / pathLength of the outline, which is `outline` in user
/// space. Without the attribute, or if its value cannot be, it stays as it is. A length of 0 stretches every dash without
/// end, so that the line is whole. Of a stroke that does not scale dashes are measured as it is drawn: under `map`, in px,
/// of which one is `pixel` in the unit of the scene.
SvgStyle with_measured_dashes(SvgStyle style, const SvgNode& node, const std::vector<Path>& outline, const Affine& map,
                              double pixel);

}  // namespace rinceau
