#include "scene/svg_attribute_check.h"

#include <algorithm>
#include <array>
#include <span>

#include "scene/svg_number.h"
#include "scene/svg_path_length.h"
#include "scene/svg_viewport.h"

namespace rinceau {
namespace {

using Accepts = bool (*)(std::string_view value);

bool is_length(std::string_view value) { return parse_length(value, {}, LengthAxis::x).has_value(); }

bool is_size(std::string_view value) {
    const auto length = parse_length(value, {}, LengthAxis::x);
    return length && *length >= 0;
}

bool is_size_or_auto(std::string_view value) { return value == "auto" || is_size(value); }

bool is_marker_reference(std::string_view value) {
    static constexpr std::string_view words[] = {"left", "center", "right", "top", "bottom"};
    return std::ranges::find(words, value) != std::end(words) || is_length(value);
}

bool is_orientation(std::string_view value) {
    if (value == "auto" || value == "auto-start-reverse") return true;
    TextCursor cursor{value};
    if (!read_number(cursor)) return false;
    const std::string_view unit = value.substr(cursor.at);
    return unit.empty() || unit == "deg" || unit == "grad" || unit == "rad" || unit == "turn";
}

bool is_view_box(std::string_view value) {
    const auto box = parse_view_box(value);
    return box && box->width > 0 && box->height > 0;
}
bool is_path_length(std::string_view value) { return parse_path_length(value).has_value(); }
bool is_aspect(std::string_view value) { return parse_aspect_ratio(value).has_value(); }
bool is_share(std::string_view value) { return parse_share(value).has_value(); }
bool is_units(std::string_view value) { return value == "userSpaceOnUse" || value == "objectBoundingBox"; }
bool is_marker_units(std::string_view value) { return value == "userSpaceOnUse" || value == "strokeWidth"; }
bool is_spread(std::string_view value) { return value == "pad" || value == "reflect" || value == "repeat"; }

struct Attribute {
    std::string_view element, name;
    Accepts accepts;
    std::string_view instead;
};

constexpr std::string_view zero = "0 is taken";
constexpr std::string_view undrawn = "they are not drawn";
constexpr std::string_view all_of_it = "100% is taken";
constexpr std::string_view default_value = "the default is taken";
constexpr std::string_view no_view_box = "no view box is taken (nothing is drawn if its size is 0)";
constexpr std::string_view no_radius = "no radius is taken";
constexpr std::string_view true_length = "dashes count in user units";

constexpr auto attributes = [] {
    auto all = std::to_array<Attribute>({
        {"rect", "x", is_length, zero},
        {"rect", "y", is_length, zero},
        {"rect", "width", is_size_or_auto, undrawn},
        {"rect", "height", is_size_or_auto, undrawn},
        {"rect", "rx", is_size_or_auto, no_radius},
        {"rect", "ry", is_size_or_auto, no_radius},
        {"circle", "cx", is_length, zero},
        {"circle", "cy", is_length, zero},
        {"circle", "r", is_size, undrawn},
        {"ellipse", "cx", is_length, zero},
        {"ellipse", "cy", is_length, zero},
        {"ellipse", "rx", is_size_or_auto, "the other radius is taken"},
        {"ellipse", "ry", is_size_or_auto, "the other radius is taken"},
        {"line", "x1", is_length, zero},
        {"line", "y1", is_length, zero},
        {"line", "x2", is_length, zero},
        {"line", "y2", is_length, zero},
        {"use", "x", is_length, zero},
        {"use", "y", is_length, zero},
        {"use", "width", is_size_or_auto, default_value},
        {"use", "height", is_size_or_auto, default_value},
        {"svg", "x", is_length, zero},
        {"svg", "y", is_length, zero},
        {"svg", "width", is_size_or_auto, all_of_it},
        {"svg", "height", is_size_or_auto, all_of_it},
        {"svg", "viewBox", is_view_box, no_view_box},
        {"svg", "preserveAspectRatio", is_aspect, default_value},
        {"symbol", "viewBox", is_view_box, no_view_box},
        {"symbol", "preserveAspectRatio", is_aspect, default_value},
        {"marker", "viewBox", is_view_box, no_view_box},
        {"marker", "preserveAspectRatio", is_aspect, default_value},
        {"marker", "markerWidth", is_size, default_value},
        {"marker", "markerHeight", is_size, default_value},
        {"marker", "markerUnits", is_marker_units, default_value},
        {"marker", "refX", is_marker_reference, zero},
        {"marker", "refY", is_marker_reference, zero},
        {"marker", "orient", is_orientation, zero},
        {"clipPath", "clipPathUnits", is_units, default_value},
        {"linearGradient", "x1", is_length, default_value},
        {"linearGradient", "y1", is_length, default_value},
        {"linearGradient", "x2", is_length, default_value},
        {"linearGradient", "y2", is_length, default_value},
        {"linearGradient", "gradientUnits", is_units, default_value},
        {"linearGradient", "spreadMethod", is_spread, default_value},
        {"radialGradient", "cx", is_length, default_value},
        {"radialGradient", "cy", is_length, default_value},
        {"radialGradient", "fx", is_length, default_value},
        {"radialGradient", "fy", is_length, default_value},
        {"radialGradient", "r", is_size, default_value},
        {"radialGradient", "fr", is_size, default_value},
        {"radialGradient", "gradientUnits", is_units, default_value},
        {"radialGradient", "spreadMethod", is_spread, default_value},
        {"path", "pathLength", is_path_length, true_length},
        {"rect", "pathLength", is_path_length, true_length},
        {"circle", "pathLength", is_path_length, true_length},
        {"ellipse", "pathLength", is_path_length, true_length},
        {"line", "pathLength", is_path_length, true_length},
        {"polyline", "pathLength", is_path_length, true_length},
        {"polygon", "pathLength", is_path_length, true_length},
        {"stop", "offset", is_share, zero},
    });
    std::ranges::sort(all, [](const Attribute& a, const Attribute& b) {
        return a.element != b.element ? a.element < b.element : a.name < b.name;
    });
    return all;
}();

/// These may come from style sheets as well.
bool is_geometry_property(std::string_view name) {
    static constexpr std::string_view names[] = {"cx", "cy", "height", "r", "rx", "ry", "width", "x", "y"};
    return std::ranges::binary_search(names, name);
}

/// Properties that move, cut or paint what they stand on; sorted.
constexpr std::string_view unsupported_properties[] = {"-webkit-clip-path",
                                                       "-webkit-filter",
                                                       "-webkit-mask",
                                                       "-webkit-mask-image",
                                                       "-webkit-transform",
                                                       "animation",
                                                       "animation-name",
                                                       "backdrop-filter",
                                                       "mask-border",
                                                       "mask-image",
                                                       "offset",
                                                       "offset-path",
                                                       "perspective",
                                                       "rotate",
                                                       "scale",
                                                       "translate",
                                                       "zoom"};
constexpr std::string_view page_properties[] = {"background", "background-color", "background-image"};

bool says_nothing(std::string_view value) {
    static constexpr std::string_view words[] = {"0",    "1",      "auto",   "inherit",     "initial",
                                                 "none", "normal", "revert", "transparent", "unset"};
    return std::ranges::binary_search(words, value);
}

void check_properties(SvgReader& reader, const SvgNode& node, const SpecifiedStyle& specified) {
    for (const auto& [property, value] : specified) {
        const bool unsupported =
            std::ranges::binary_search(unsupported_properties, std::string_view(property)) ||
            (node.parent == nullptr && std::ranges::binary_search(page_properties, std::string_view(property)));
        if (!unsupported || says_nothing(value)) continue;
        reader.warnings.add_value("{} " + std::string(node.name) + " elements have the property " + property +
                                      ": {value}, which is not supported; it is left out",
                                  value, node);
    }
}

}  // namespace

void check_attributes(SvgReader& reader, const SvgNode& node, const SpecifiedStyle& specified) {
    const auto* const first = std::ranges::lower_bound(attributes, node.name, {}, &Attribute::element);
    const auto* const last = std::ranges::upper_bound(attributes, node.name, {}, &Attribute::element);
    for (const Attribute& attribute : std::span(first, last)) {
        const std::string* property = is_geometry_property(attribute.name) ? find_value(specified, attribute.name) : nullptr;
        if (property != nullptr && !attribute.accepts(*property) && !says_nothing(*property))
            note_fault(reader, node, attribute.name, *property, attribute.instead);
        if (property != nullptr) continue;
        const std::string_view* value = find_attribute(node, attribute.name);
        if (value != nullptr && !attribute.accepts(trimmed(*value)))
            note_fault(reader, node, attribute.name, *value, attribute.instead);
    }
    check_properties(reader, node, specified);
}

}  // namespace rinceau
