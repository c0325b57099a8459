#pragma once
// Computed style: from specified values and the parent's style, inheritance done, keywords and lengths understood.

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/style.h"
#include "scene/svg_color.h"
#include "scene/svg_css.h"
#include "scene/svg_units.h"

namespace rinceau {

enum class PaintPart : std::uint8_t { fill, stroke, markers };

/// What a drawing says of an element's look. Lengths are user units of the element that specified them.
struct SvgStyle {
    // Inherited.
    ParsedColor color;  ///< never currentColor
    ParsedPaint fill{PaintKind::color, {}, {}, false, PaintKind::none, {}};
    ParsedPaint stroke;
    double fill_opacity = 1, stroke_opacity = 1;
    FillRule fill_rule = FillRule::nonzero, clip_rule = FillRule::nonzero;
    double stroke_width = 1;
    LineCap cap = LineCap::butt;
    LineJoin join = LineJoin::miter;
    double miter_limit = 4;
    std::vector<double> dashes;  ///< even count, empty = solid
    double dash_offset = 0;
    std::string marker_start, marker_mid, marker_end;  ///< "#id", empty = none
    std::array<PaintPart, 3> paint_order{PaintPart::fill, PaintPart::stroke, PaintPart::markers};
    bool visible = true;
    bool crisp_edges = false;
    double font_size = 16;  ///< px

    // Of the element alone.
    bool displayed = true;
    double opacity = 1;
    std::string clip_path, mask, filter;   ///< as written, empty = none
    std::optional<bool> overflow_visible;  ///< nothing: the default of the element
    bool non_scaling_stroke = false;
    bool blended = false;   ///< mix-blend-mode other than normal
    bool isolated = false;  ///< isolation: isolate
    std::string transform;  ///< as written, empty = none
    std::string transform_origin;
    bool fill_box = false;  ///< transform-box: fill-box or the like
    ParsedColor stop_color;
    double stop_opacity = 1;
    std::vector<std::pair<std::string, std::string>> faults;  ///< (property, value) of values that are not understood
};

/// The style of a child of an element with style `parent`. `units` are of the child's surroundings (the parent's font size).
/// A value that is not understood is as if it were not there, and in `faults`.
SvgStyle computed_style(const SpecifiedStyle& specified, const SvgStyle& parent, const UnitContext& units);

/// Is it a value that computed_style takes? True for all values of properties that it does not know.
bool is_understood(std::string_view property, std::string_view value);

/// `color` with currentColor put in.
ParsedColor resolved_color(const ParsedColor& color, const SvgStyle& style);

/// Attributes that are style: a name in this list stands in an attribute for the CSS property of the same name.
bool is_presentation_attribute(std::string_view name);
/// CSS properties that children take over from their parents, those that only matter to text included.
bool is_inherited_property(std::string_view name);

}  // namespace rinceau
