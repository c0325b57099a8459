#pragma once
// Transforms in text: the attribute `transform`, the CSS property of that name, `transform-origin`.

#include <optional>
#include <string>
#include <string_view>

#include "geometry/affine.h"
#include "geometry/box.h"
#include "scene/svg_units.h"

namespace rinceau {

struct ParsedTransform {
    std::optional<Affine> map;  ///< in SVG's space (y down, positive angles clockwise); nothing if the text is faulty
    std::string fault;          ///< what is wrong, else empty
};

/// The attribute's syntax (also gradientTransform, patternTransform): matrix translate scale rotate skewX skewY with plain
/// numbers. An empty text is the identity.
ParsedTransform parse_transform_attribute(std::string_view text);

/// CSS syntax: lengths with units, angles in deg rad grad turn, translateX/Y, scaleX/Y, skew, percentages of the
/// `reference` box (y down). "none" is the identity. Plain numbers are px and degrees, as in the attribute.
/// Three-dimensional functions are faults.
ParsedTransform parse_css_transform(std::string_view text, const UnitContext& context, const Box& reference);

/// transform-origin: one to three of lengths, percentages of `reference` (y down; from its low corner), left center right
/// top bottom; the point in user space. Lengths count from the low corner of `reference`.
std::optional<Point> parse_transform_origin(std::string_view text, const UnitContext& context, const Box& reference);

/// Both properties together: origin to 0, map, back.
Affine about(const Affine& map, Point origin);

}  // namespace rinceau
