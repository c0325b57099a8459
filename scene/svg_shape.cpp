#include "scene/svg_shape.h"

#include <algorithm>
#include <cmath>

#include "scene/svg_marker.h"
#include "scene/svg_outline.h"
#include "scene/svg_paint.h"
#include "scene/svg_path_data.h"
#include "scene/svg_path_length.h"
#include "scene/svg_verbatim.h"

namespace rinceau {
namespace {

// A map whose sides differ by less than this share is even: transforms are written with six to nine digits.
constexpr double evenness = 1e-6;
// Renderers draw square dots of length 0 wrongly or not at all, so that they become lines this much shorter than wide, and
// no shorter (px) than what the fixed-point numbers of cairo, in steps of 1/256, can tell from 0.
constexpr double dot_length = 0.002;
constexpr double shortest_dot = 1.0 / 64;

bool is_even(const Affine& map) {
    const double size = map.a * map.a + map.b * map.b + map.c * map.c + map.d * map.d;
    return std::abs(map.a * map.a + map.b * map.b - map.c * map.c - map.d * map.d) <= evenness * size &&
           std::abs(map.a * map.c + map.b * map.d) <= evenness * size;
}

/// The symmetric positive part of the polar decomposition of the map's linear part, at determinant 1.
Linear2 pen_of(const Affine& map) {
    // M M^T = P^2; the square root of a symmetric 2 x 2 matrix A is (A + sqrt(det A) I) / sqrt(tr A + 2 sqrt(det A)).
    const double size = std::abs(determinant(map));
    const double xx = (map.a * map.a + map.c * map.c) / size, yy = (map.b * map.b + map.d * map.d) / size;
    const double xy = (map.a * map.b + map.c * map.d) / size;
    const double scale = std::sqrt(xx + yy + 2);
    return {(xx + 1) / scale, xy / scale, xy / scale, (yy + 1) / scale};
}

double reach_of(const Affine& map) { return std::hypot(std::hypot(map.a, map.b), std::hypot(map.c, map.d)); }

bool is_dot(const Path& path) {
    return std::ranges::all_of(path.segments, [&](const Segment& segment) {
        return segment.to == path.start &&
               (segment.straight || (segment.control1 == path.start && segment.control2 == path.start));
    });
}

bool encloses_area(const Path& path) {
    const auto count = path.segments.size();
    return count > 1 || (count == 1 && !path.segments.front().straight);
}

/// Dots without caps draw nothing; square ones get the direction that they have in user space.
std::vector<Path> with_dots_settled(std::vector<Path> outline, const Affine& map, const Style& style) {
    const bool capped = paints_stroke(style) && style.stroke.cap != LineCap::butt;
    if (!capped) std::erase_if(outline, is_dot);
    if (!paints_stroke(style)) std::erase_if(outline, [](const Path& path) { return !encloses_area(path); });
    std::vector<Path> paths = transformed(outline, map);
    if (!capped || style.stroke.cap != LineCap::square) return paths;
    const double length = std::max(dot_length * style.stroke.width, std::min(shortest_dot, 0.25 * style.stroke.width));
    const Point half = Point{map.a, map.b} * (0.5 * length / std::hypot(map.a, map.b));
    for (Path& path : paths)
        if (is_dot(path)) path = {path.start - half, {line_to(path.start + half)}, false};
    return paths;
}

struct ShapeStyle {
    Style style;
    bool unsupported = false;
};

ShapeStyle scene_style(SvgReader& reader, const SvgContext& context, const std::vector<Path>& outline) {
    const SvgStyle& given = context.style;
    const Box box = bounds(outline);
    ShapeStyle result;
    Style& style = result.style;
    const SvgPaint fill = resolve_paint(reader, context, given.fill, box);
    style.fill = fill.paint;
    style.fill_opacity = given.fill_opacity * fill.opacity;
    style.fill_rule = given.fill_rule;
    if (style.fill_opacity <= 0 || std::ranges::none_of(outline, encloses_area)) style.fill = NoPaint{};
    const SvgPaint stroke = resolve_paint(reader, context, given.stroke, box);
    const Affine map = scene_map(context);
    style.stroke = stroke_under(with_measured_dashes(given, *context.node, outline, map, reader.pixel), map, reader.pixel);
    style.stroke.opacity = given.stroke_opacity * stroke.opacity;
    const bool strokes = style.stroke.width > 0 && style.stroke.opacity > 0;
    if (strokes) style.stroke.paint = stroke.paint;
    style.crisp_edges = given.crisp_edges;
    result.unsupported = (fill.unsupported && given.fill_opacity > 0) || (stroke.unsupported && strokes);
    return result;
}

Style only_fill(Style style) {
    style.stroke = {};
    return style;
}

Style only_stroke(Style style) {
    style.fill = NoPaint{};
    return style;
}

void draw_paths(SvgReader& reader, const SvgContext& context, const std::vector<Path>& outline, const Style& style) {
    if (!paints_fill(style) && !paints_stroke(style)) return;
    Element element;
    element.paths = with_dots_settled(outline, scene_map(context), style);
    if (element.paths.empty()) {
        reader.warnings.add("{} shapes of length 0 without round or square ends draw nothing and are left out",
                            *context.node);
        return;
    }
    element.style = style;
    if (const std::string_view* id = find_attribute(*context.node, "id")) element.id = *id;
    add_element(reader, std::move(element), *context.node);
}

/// Also of a stroke that is stretched so far that its outline leaves the range where its pen is round: it is written there.
bool stroke_is_in_range(const SvgContext& context, const std::vector<Path>& outline) {
    const Affine map = scene_map(context);
    if (context.style.stroke_width * context.style.miter_limit * reach_of(map) > largest_coordinate) return false;
    if (context.style.stroke.kind == PaintKind::none || context.style.non_scaling_stroke || is_even(map)) return true;
    const Linear2 pen = pen_of(map);
    return is_in_range(transformed(outline, inverse(Affine{pen.a, pen.b, pen.c, pen.d, 0, 0}) * map));
}

/// Fill, stroke and markers in their order; fill and stroke are one element unless the markers come between them.
void draw_parts(SvgReader& reader, const SvgContext& context, const std::vector<Path>& outline, Style style, bool marked) {
    const auto& order = context.style.paint_order;
    const auto rank = [&](PaintPart part) { return std::ranges::find(order, part) - order.begin(); };
    style.stroke_first = paints_fill(style) && paints_stroke(style) && rank(PaintPart::stroke) < rank(PaintPart::fill);
    if (!marked || rank(PaintPart::markers) != 1) {
        if (marked && rank(PaintPart::markers) == 0) draw_markers(reader, context, outline, style);
        draw_paths(reader, context, outline, style);
        if (marked && rank(PaintPart::markers) == 2) draw_markers(reader, context, outline, style);
        return;
    }
    const bool stroke_first = std::exchange(style.stroke_first, false);
    draw_paths(reader, context, outline, stroke_first ? only_stroke(style) : only_fill(style));
    draw_markers(reader, context, outline, style);
    draw_paths(reader, context, outline, stroke_first ? only_fill(style) : only_stroke(style));
}

}  // namespace

Stroke stroke_under(const SvgStyle& style, const Affine& map, double pixel) {
    Stroke stroke;
    stroke.cap = style.cap;
    stroke.join = style.join;
    stroke.miter_limit = style.miter_limit;
    const bool fixed = style.non_scaling_stroke;
    const double scale = fixed ? pixel : std::sqrt(std::abs(determinant(map)));
    stroke.width = style.stroke_width * scale;
    stroke.dashes = style.dashes;
    for (double& dash : stroke.dashes) dash *= scale;
    if (!stroke.dashes.empty()) stroke.dash_offset = style.dash_offset * scale;
    if (!fixed && !is_even(map)) stroke.pen = pen_of(map);
    return stroke;
}

void draw_shape(SvgReader& reader, const SvgContext& context) {
    if (!context.style.visible) return;
    const std::vector<Path> outline = outline_of(reader, context);
    if (outline.empty()) return;
    if (!is_in_range(outline) || !is_in_range(transformed(outline, scene_map(context))) ||
        !stroke_is_in_range(context, outline)) {
        reader.warnings.add("{} shapes have lengths or coordinates beyond 1e15 and are left out", *context.node);
        return;
    }
    const ShapeStyle shape = scene_style(reader, context, outline);
    const bool marked = takes_markers(context.node->name) && has_markers(context.style);
    if (shape.unsupported) {
        Element measured{.paths = transformed(outline, scene_map(context)), .style = shape.style};
        if (context.style.fill.kind != PaintKind::none) measured.style.fill = Color{};
        if (context.style.stroke.kind != PaintKind::none) measured.style.stroke.paint = Color{};
        const Box box = marked ? Box{} : painted_box(measured);
        keep_verbatim(reader, context, box,
                      "{} shapes painted with a pattern, or with a gradient whose focus lies outside its circle, are kept "
                      "as they are");
        return;
    }
    if (context.style.non_scaling_stroke && paints_stroke(shape.style))
        reader.warnings.add("{} strokes that do not scale (vector-effect) have the width of the drawing's own size",
                            *context.node);
    if (!marked && !paints_fill(shape.style) && !paints_stroke(shape.style))
        reader.warnings.add("{} shapes have neither fill nor stroke and are left out", *context.node);
    draw_parts(reader, context, outline, shape.style, marked);
}

}  // namespace rinceau
