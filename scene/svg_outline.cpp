#include "scene/svg_outline.h"

#include <algorithm>
#include <cmath>

#include "scene/svg_number.h"
#include "scene/svg_path_data.h"
#include "scene/svg_shapes.h"

namespace rinceau {
namespace {

std::optional<double> given_length(const SvgContext& context, std::string_view name, LengthAxis axis) {
    if (const std::string* value = find_value(context.specified, name))
        if (const auto length = parse_length(*value, context.units, axis)) return length;
    if (const std::string_view* value = find_attribute(*context.node, name))
        return parse_length(trimmed(*value), context.units, axis);
    return std::nullopt;
}

/// Path data from the attribute, or from CSS as path("..."); empty if there are none.
std::string_view path_data(const SvgContext& context) {
    std::string_view data;
    if (const std::string_view* value = find_attribute(*context.node, "d")) data = *value;
    if (const std::string* value = find_value(context.specified, "d"); value != nullptr && value->starts_with("path(")) {
        const std::size_t open = value->find_first_of("\"'"), close = value->find_last_of("\"'");
        if (open != std::string::npos && close > open) data = std::string_view(*value).substr(open + 1, close - open - 1);
    }
    return trimmed(data) == "none" ? std::string_view() : trimmed(data);
}

std::string_view rest_of(std::string_view data, std::size_t at) { return at < data.size() ? data.substr(at) : "its end"; }

std::vector<Path> path_outline(SvgReader& reader, const SvgContext& context) {
    const std::string_view data = path_data(context);
    if (data.empty()) return {};
    ParsedPath parsed = parse_path_data(data);
    if (parsed.faulty)
        reader.warnings.add_value(
            "{} paths have faulty data (attribute d, before \"{value}\") and are drawn up to the fault",
            rest_of(data, parsed.fault_at), *context.node);
    return std::move(parsed.paths);
}

std::vector<Path> points_outline(SvgReader& reader, const SvgContext& context, bool closed) {
    const std::string_view* data = find_attribute(*context.node, "points");
    if (data == nullptr) return {};
    const ParsedPoints parsed = parse_points(*data);
    if (parsed.faulty)
        reader.warnings.add_value(
            "{} polygons or polylines have faulty points (before \"{value}\") and are drawn up to the fault",
            rest_of(*data, parsed.fault_at), *context.node);
    return polyline(parsed.points, closed);
}

std::vector<Path> rectangle_outline(const SvgContext& context) {
    return rectangle({.x = length_of(context, "x", LengthAxis::x, 0),
                      .y = length_of(context, "y", LengthAxis::y, 0),
                      .width = length_of(context, "width", LengthAxis::x, 0),
                      .height = length_of(context, "height", LengthAxis::y, 0),
                      .rx = given_length(context, "rx", LengthAxis::x),
                      .ry = given_length(context, "ry", LengthAxis::y)});
}

std::vector<Path> ellipse_outline(const SvgContext& context) {
    const auto rx = given_length(context, "rx", LengthAxis::x), ry = given_length(context, "ry", LengthAxis::y);
    const Point at{length_of(context, "cx", LengthAxis::x, 0), length_of(context, "cy", LengthAxis::y, 0)};
    // A missing radius is auto: the other one.
    return ellipse(at, rx.value_or(ry.value_or(0)), ry.value_or(rx.value_or(0)));
}

}  // namespace

double length_of(const SvgContext& context, std::string_view name, LengthAxis axis, double fallback) {
    return given_length(context, name, axis).value_or(fallback);
}

bool is_shape(std::string_view name) {
    static constexpr std::string_view shapes[] = {"path", "rect", "circle", "ellipse", "line", "polyline", "polygon"};
    return std::ranges::find(shapes, name) != std::end(shapes);
}

bool takes_markers(std::string_view name) {
    return name == "path" || name == "line" || name == "polyline" || name == "polygon";
}

bool is_in_range(const std::vector<Path>& paths) {
    const auto fits = [](Point p) { return std::abs(p.x) <= largest_coordinate && std::abs(p.y) <= largest_coordinate; };
    return std::ranges::all_of(paths, [&](const Path& path) {
        return fits(path.start) && std::ranges::all_of(path.segments, [&](const Segment& segment) {
                   return fits(segment.control1) && fits(segment.control2) && fits(segment.to);
               });
    });
}

std::vector<Path> outline_of(SvgReader& reader, const SvgContext& context) {
    const std::string_view name = context.node->name;
    if (name == "path") return path_outline(reader, context);
    if (name == "rect") return rectangle_outline(context);
    if (name == "ellipse") return ellipse_outline(context);
    if (name == "polyline" || name == "polygon") return points_outline(reader, context, name == "polygon");
    if (name == "circle") {
        const double r = length_of(context, "r", LengthAxis::diagonal, 0);
        return ellipse({length_of(context, "cx", LengthAxis::x, 0), length_of(context, "cy", LengthAxis::y, 0)}, r, r);
    }
    if (name == "line")
        return line({length_of(context, "x1", LengthAxis::x, 0), length_of(context, "y1", LengthAxis::y, 0)},
                    {length_of(context, "x2", LengthAxis::x, 0), length_of(context, "y2", LengthAxis::y, 0)});
    return {};
}

std::vector<std::pair<std::size_t, std::size_t>> arc_joints_of(const SvgContext& context) {
    if (context.node->name != "path") return {};
    return parse_path_data(path_data(context)).arc_joints;
}

}  // namespace rinceau
