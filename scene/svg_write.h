#pragma once
// SVG out: a scene as a plain SVG file, one element a shape, in paint order.

#include <string>

#include "scene/element.h"

namespace rinceau {

/// The scene as an SVG document. read_svg of the result gives the same scene (numbers in shortest round-trip form); to
/// rounding where a pen is no circle. Elements that share an id: only the first one keeps it.
std::string write_svg(const Scene& scene);

/// "M0 0L1 2C..Z" of paths whose y axis points UP, in SVG's y-down convention. Numbers are written with at most `digits`
/// significant digits, or in shortest round-trip form when digits = 0.
std::string svg_path_data(const std::vector<Path>& paths, int digits = 0);

/// The presentation attributes of a style (each as ` name="value"`) that differ from SVG's initial values, without
/// gradients' definitions, and those definitions apart; gradient ids are `id_prefix` + "f" (fill) or "s" (stroke).
/// Space: y down. The pen is not in them: svg_element_text draws with it. Nor are width and dashes of a fixed stroke, which
/// depend on the scale that the shape is drawn in.
struct SvgStyleText {
    std::string attributes;
    std::string definitions;
};
SvgStyleText svg_style_text(const Style& style, const std::string& id_prefix);

/// "#ffcc00", or "#fc0" where that is the same.
std::string svg_color_text(const Color& color);

/// Width and dashes of a stroke, times `factor`, as presentation attributes; `digits` as in svg_path_data.
std::string svg_stroke_lengths(const Stroke& stroke, double factor = 1, int digits = 0);

/// The value of `transform` for a map given in y-up space, in SVG's y-down convention, exact; empty for the identity.
std::string svg_transform_text(const Affine& map);

/// One element as SVG, y down, without the element's id: `body` draws it, `definitions` belongs into <defs>. `digits` as in
/// svg_path_data, for the path data; ids in the definitions start with `id_prefix`. A stroke whose pen is no circle is drawn
/// by an element with transform = pen.
struct SvgElementText {
    std::string body;
    std::string definitions;
};
SvgElementText svg_element_text(const Element& element, const std::string& id_prefix, int digits = 0);

/// The text with & < > " replaced by entities, fit for an attribute or for content.
std::string xml_escaped(const std::string& text);

/// Opening tag of the root element for the scene's viewport, and its size.
std::string svg_root_tag(const Box& viewport, bool sized);

}  // namespace rinceau
