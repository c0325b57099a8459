#include "scene/svg_marker.h"

#include <algorithm>
#include <cmath>

#include "geometry/angle.h"
#include "scene/svg_attribute_check.h"
#include "scene/svg_clip.h"
#include "scene/svg_draw.h"
#include "scene/svg_effects.h"
#include "scene/svg_number.h"
#include "scene/svg_outline.h"
#include "scene/svg_viewport.h"

namespace rinceau {
namespace {

/// A vertex with the directions in which the outline arrives and leaves (zero where it does not).
struct Vertex {
    Point at;
    Point arriving, leaving;
};

Point first_not_zero(std::initializer_list<Point> candidates) {
    for (const Point p : candidates)
        if (norm(p) > 0) return p;
    return {};
}

void add_vertices(const Path& path, std::vector<Vertex>& vertices) {
    const std::size_t first = vertices.size();
    vertices.push_back({path.start, {}, {}});
    const auto add = [&](const Segment& segment) {
        const Point from = vertices.back().at, to = segment.to;
        const Point chord = to - from;
        if (segment.straight) {
            vertices.back().leaving = chord;
            vertices.push_back({to, chord, {}});
            return;
        }
        vertices.back().leaving = first_not_zero({segment.control1 - from, segment.control2 - from, chord});
        vertices.push_back({to, first_not_zero({to - segment.control2, to - segment.control1, chord}), {}});
    };
    for (const Segment& segment : path.segments) add(segment);
    if (!path.closed) return;
    add(line_to(path.start));
    // At the seam the outline goes on where it began.
    if (norm(vertices.back().arriving) == 0 && vertices.size() > first + 2)
        vertices.back().arriving = vertices[vertices.size() - 2].arriving;
    vertices.back().leaving = vertices[first].leaving;
    vertices[first].arriving = vertices.back().arriving;
}

/// `joints` are the ends of segments that are no vertices: (sub-path, segment).
std::vector<Vertex> vertices_of(const std::vector<Path>& outline,
                                const std::vector<std::pair<std::size_t, std::size_t>>& joints) {
    std::vector<Vertex> all;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        std::vector<Vertex> vertices;
        add_vertices(outline[i], vertices);
        for (std::size_t v = 0; v < vertices.size(); ++v)
            // Vertex v ends segment v - 1.
            if (v == 0 || !std::ranges::binary_search(joints, std::pair(i, v - 1))) all.push_back(vertices[v]);
    }
    return all;
}

double vertex_angle(const Vertex& vertex) {
    const bool arrives = norm(vertex.arriving) > 0, leaves = norm(vertex.leaving) > 0;
    if (!arrives && !leaves) return 0;
    if (!arrives) return arg(vertex.leaving);
    if (!leaves) return arg(vertex.arriving);
    const double arrival = arg(vertex.arriving);
    return arrival + 0.5 * wrap_angle(arg(vertex.leaving) - arrival);
}

struct MarkerView {
    Affine map;               ///< from marker content to the marked path's user space, at the origin
    std::vector<Point> clip;  ///< corners in content space; empty = not clipped
    double width = 0, height = 0;
};

/// Nothing if the marker draws nothing.
std::optional<MarkerView> marker_view(const SvgContext& marker, double stroke_width) {
    MarkerView view;
    const double width = length_of(marker, "markerWidth", LengthAxis::x, 3),
                 height = length_of(marker, "markerHeight", LengthAxis::y, 3);
    if (!(width > 0) || !(height > 0)) return std::nullopt;
    const std::string_view* units = find_attribute(*marker.node, "markerUnits");
    const double scale = units != nullptr && trimmed(*units) == "userSpaceOnUse" ? 1 : stroke_width;
    if (!(scale > 0)) return std::nullopt;
    view.width = width, view.height = height;
    Box shown{{0, 0}, {width, height}};
    if (const std::string_view* text = find_attribute(*marker.node, "viewBox"))
        if (const auto box = parse_view_box(*text)) {
            if (!(box->width > 0) || !(box->height > 0)) return std::nullopt;
            AspectRatio aspect;
            if (const std::string_view* ratio = find_attribute(*marker.node, "preserveAspectRatio"))
                aspect = parse_aspect_ratio(*ratio).value_or(aspect);
            view.map = view_box_map(*box, aspect, width, height);
            view.width = box->width, view.height = box->height;
            const Affine back = inverse(view.map);
            shown = {apply(back, {0, 0}), apply(back, {width, height})};
        }
    const auto reference = [&](std::string_view name, LengthAxis axis) {
        const std::string_view* value = find_attribute(*marker.node, name);
        if (value == nullptr) return 0.0;
        const bool across = axis == LengthAxis::x;
        const double low = across ? shown.low.x : shown.low.y, size = across ? width : height;
        const std::string_view word = trimmed(*value);
        if (word == "left" || word == "top") return low;
        if (word == "center") return low + 0.5 * size;
        if (word == "right" || word == "bottom") return low + size;
        return parse_length(word, marker.units, axis).value_or(0);
    };
    const Point anchor = apply(view.map, {reference("refX", LengthAxis::x), reference("refY", LengthAxis::y)});
    view.map = Affine{scale, 0, 0, scale, 0, 0} * Affine{1, 0, 0, 1, -anchor.x, -anchor.y} * view.map;
    if (!marker.style.overflow_visible.value_or(false))
        view.clip = {shown.low, {shown.high.x, shown.low.y}, shown.high, {shown.low.x, shown.high.y}};
    return view;
}

/// One marker definition, ready to be drawn at many vertices.
struct Marker {
    const SvgNode* node = nullptr;
    std::vector<std::unique_ptr<SvgContext>> above;
    SvgContext context;
    std::optional<MarkerView> view;
    std::string_view orient;
};

std::optional<Marker> find_marker(SvgReader& reader, const SvgContext& shape, const std::string& reference) {
    if (reference.empty()) return std::nullopt;
    const SvgNode* node = find_reference(reader, reference);
    if (node == nullptr || !is_svg(*node) || node->name != "marker") {
        reader.warnings.add("{} markers refer to a marker that does not exist", *shape.node);
        return std::nullopt;
    }
    if (reader.open.contains(node)) {
        reader.warnings.add("{} references that lead back to themselves are skipped", *shape.node);
        return std::nullopt;
    }
    Marker marker;
    marker.node = node;
    marker.above = ancestor_contexts(reader, *node);
    marker.above.back()->depth += shape.depth;
    marker.context = enter(reader, *marker.above.back(), *node);
    check_attributes(reader, *node, marker.context.specified);
    marker.view = marker_view(marker.context, shape.style.stroke_width);
    if (const std::string_view* orient = find_attribute(*node, "orient")) marker.orient = trimmed(*orient);
    return marker;
}

double marker_angle(const Marker& marker, const Vertex& vertex, bool at_start) {
    if (marker.orient == "auto") return vertex_angle(vertex);
    if (marker.orient == "auto-start-reverse") return vertex_angle(vertex) + (at_start ? pi : 0);
    TextCursor cursor{marker.orient};
    const double value = read_number(cursor).value_or(0);
    if (skip_token(cursor, "rad")) return value;
    if (skip_token(cursor, "grad")) return value * pi / 200;
    return skip_token(cursor, "turn") ? value * two_pi : radians(value);
}

void draw_marker(SvgReader& reader, const SvgContext& shape, Marker& marker, const Vertex& vertex, bool at_start,
                 const Style& style) {
    // `display` does not apply to markers.
    if (!marker.view) return;
    const double angle = marker_angle(marker, vertex, at_start), c = std::cos(angle), s = std::sin(angle);
    marker.context.map = shape.map * Affine{c, s, -s, c, vertex.at.x, vertex.at.y} * marker.view->map;
    marker.context.units.width = marker.view->width;
    marker.context.units.height = marker.view->height;
    marker.context.context_style = &style;
    const SvgMark mark = mark_of(reader);
    const SvgOpening opening(reader, *marker.node);
    draw_children(reader, marker.context);
    finish_effects(reader, marker.context, mark);
    if (!marker.view->clip.empty())
        clip_to_polygon(reader, mark.elements, marker.context.map, marker.view->clip, *marker.node);
}

}  // namespace

void draw_markers(SvgReader& reader, const SvgContext& context, const std::vector<Path>& outline, const Style& style) {
    const std::vector<Vertex> vertices = vertices_of(outline, arc_joints_of(context));
    if (vertices.empty()) return;
    auto start = find_marker(reader, context, context.style.marker_start);
    auto mid = find_marker(reader, context, context.style.marker_mid);
    auto end = find_marker(reader, context, context.style.marker_end);
    if (start) draw_marker(reader, context, *start, vertices.front(), true, style);
    for (std::size_t i = 1; mid && i + 1 < vertices.size(); ++i)
        draw_marker(reader, context, *mid, vertices[i], false, style);
    if (end) draw_marker(reader, context, *end, vertices.back(), false, style);
}

}  // namespace rinceau
