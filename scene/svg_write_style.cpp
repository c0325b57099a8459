// Styles as presentation attributes, gradients as their definitions.

#include <array>

#include "scene/svg_number.h"
#include "scene/svg_write.h"

namespace rinceau {

namespace {

void add(std::string& text, std::string_view name, std::string_view value) {
    text += ' ';
    text += name;
    text += "=\"";
    text += value;
    text += '"';
}

void add_unless(std::string& text, std::string_view name, double value, double initial) {
    if (value != initial) add(text, name, svg_number(value));
}

std::string stops_text(const std::vector<GradientStop>& stops) {
    std::string text;
    for (const GradientStop& stop : stops) {
        text += "<stop";
        add(text, "offset", svg_number(stop.offset));
        add(text, "stop-color", svg_color_text(stop.color));
        add_unless(text, "stop-opacity", stop.opacity, 1);
        text += "/>";
    }
    return text;
}

// The unit gradient with the map that lays it into user space; the map's image is turned to y down.
std::string gradient_text(const Gradient& gradient, const std::string& id) {
    const bool linear = gradient.kind == GradientKind::linear;
    const std::string tag = linear ? "linearGradient" : "radialGradient";
    std::string text = "<" + tag;
    add(text, "id", id);
    add(text, "gradientUnits", "userSpaceOnUse");
    if (linear) {
        for (const auto& [name, value] : {std::pair("x1", "0"), {"y1", "0"}, {"x2", "1"}, {"y2", "0"}})
            add(text, name, value);
    } else {
        for (const auto& [name, value] : {std::pair("cx", "0"), {"cy", "0"}, {"r", "1"}}) add(text, name, value);
        add_unless(text, "fx", gradient.focus.x, 0);
        add_unless(text, "fy", gradient.focus.y, 0);
        add_unless(text, "fr", gradient.focal_radius, 0);
    }
    if (gradient.spread != GradientSpread::pad) {
        add(text, "spreadMethod", gradient.spread == GradientSpread::reflect ? "reflect" : "repeat");
    }
    const Affine& m = gradient.map;
    std::string matrix = "matrix(";
    for (const double entry : {m.a, -m.b, m.c, -m.d, m.e, -m.f}) {
        if (matrix.back() != '(') matrix += ' ';
        matrix += svg_number(entry);
    }
    add(text, "gradientTransform", matrix + ")");
    return text + ">" + stops_text(gradient.stops) + "</" + tag + ">";
}

// The attribute of a paint; a gradient's definition goes to `definitions`.
void add_paint(SvgStyleText& text, const char* name, const Paint& paint, const std::string& gradient_id) {
    if (const auto* color = std::get_if<Color>(&paint)) {
        add(text.attributes, name, svg_color_text(*color));
    } else if (const auto* gradient = std::get_if<std::shared_ptr<const Gradient>>(&paint)) {
        add(text.attributes, name, "url(#" + gradient_id + ")");
        text.definitions += gradient_text(**gradient, gradient_id);
    } else {
        add(text.attributes, name, "none");
    }
}

void add_stroke(SvgStyleText& text, const Stroke& stroke, const std::string& gradient_id) {
    if (std::holds_alternative<NoPaint>(stroke.paint)) return;
    add_paint(text, "stroke", stroke.paint, gradient_id);
    std::string& attributes = text.attributes;
    add_unless(attributes, "stroke-opacity", stroke.opacity, 1);
    if (!stroke.fixed) attributes += svg_stroke_lengths(stroke);
    if (stroke.cap != LineCap::butt) add(attributes, "stroke-linecap", stroke.cap == LineCap::round ? "round" : "square");
    if (stroke.join != LineJoin::miter)
        add(attributes, "stroke-linejoin", stroke.join == LineJoin::round ? "round" : "bevel");
    add_unless(attributes, "stroke-miterlimit", stroke.miter_limit, 4);
}

}  // namespace

std::string svg_color_text(const Color& color) {
    constexpr std::string_view digits = "0123456789abcdef";
    const std::array<std::uint8_t, 3> channels{color.red, color.green, color.blue};
    // "#aabbcc" is "#abc".
    bool is_short = true;
    for (const std::uint8_t c : channels) is_short = is_short && c / 16 == c % 16;
    std::string text = "#";
    for (const std::uint8_t c : channels) {
        text += digits[c / 16];
        if (!is_short) text += digits[c % 16];
    }
    return text;
}

std::string svg_stroke_lengths(const Stroke& stroke, double factor, int digits) {
    const auto length = [&](double value) { return svg_number(factor * value, digits); };
    std::string text;
    if (const std::string width = length(stroke.width); width != "1") add(text, "stroke-width", width);
    if (stroke.dashes.empty()) return text;
    std::string dashes;
    for (const double dash : stroke.dashes) {
        if (!dashes.empty()) dashes += ' ';
        dashes += length(dash);
    }
    add(text, "stroke-dasharray", dashes);
    if (stroke.dash_offset != 0) add(text, "stroke-dashoffset", length(stroke.dash_offset));
    return text;
}

SvgStyleText svg_style_text(const Style& style, const std::string& id_prefix) {
    SvgStyleText text;
    if (style.fill != Paint(Color{})) add_paint(text, "fill", style.fill, id_prefix + "f");
    add_unless(text.attributes, "fill-opacity", style.fill_opacity, 1);
    if (style.fill_rule == FillRule::evenodd) add(text.attributes, "fill-rule", "evenodd");
    add_stroke(text, style.stroke, id_prefix + "s");
    add_unless(text.attributes, "opacity", style.opacity, 1);
    if (style.stroke_first) add(text.attributes, "paint-order", "stroke");
    if (style.crisp_edges) add(text.attributes, "shape-rendering", "crispEdges");
    return text;
}

}  // namespace rinceau
