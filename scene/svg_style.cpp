#include "scene/svg_style.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "scene/svg_number.h"

namespace rinceau {
namespace {

/// One property: how its value changes the style; false if the value is not understood.
using ApplyValue = bool (*)(SvgStyle&, std::string_view value, const UnitContext& units);
/// How `inherit` takes a value over from the parent.
using InheritValue = void (*)(SvgStyle&, const SvgStyle& parent);

struct Property {
    std::string_view name;
    ApplyValue apply;
    InheritValue inherit;
};

template <typename T>
bool assign(T& field, const std::optional<T>& value) {
    if (value) field = *value;
    return value.has_value();
}

template <typename T, std::size_t count>
bool assign_keyword(T& field, std::string_view value, const std::pair<std::string_view, T> (&keywords)[count]) {
    for (const auto& [name, meaning] : keywords)
        if (name == value) {
            field = meaning;
            return true;
        }
    return false;
}

bool assign_rule(FillRule& field, std::string_view value) {
    static constexpr std::pair<std::string_view, FillRule> keywords[] = {{"nonzero", FillRule::nonzero},
                                                                         {"evenodd", FillRule::evenodd}};
    return assign_keyword(field, value, keywords);
}

bool assign_reference(std::string& field, std::string_view value) {
    if (value == "none") {
        field.clear();
        return true;
    }
    return assign(field, parse_url(value));
}

/// Text kept as written; "none" is empty.
bool assign_effect(std::string& field, std::string_view value) {
    field = value == "none" ? std::string() : std::string(value);
    return true;
}

bool apply_color(SvgStyle& style, std::string_view value, const UnitContext&) {
    const auto color = parse_color(value);
    // `color: currentColor` is the parent's colour, which the style already holds.
    if (color && !color->current) style.color = *color;
    return color.has_value();
}

bool apply_width(SvgStyle& style, std::string_view value, const UnitContext& units) {
    const auto width = parse_length(value, units, LengthAxis::diagonal);
    if (!width || *width < 0) return false;
    style.stroke_width = *width;
    return true;
}

bool apply_cap(SvgStyle& style, std::string_view value, const UnitContext&) {
    static constexpr std::pair<std::string_view, LineCap> keywords[] = {
        {"butt", LineCap::butt}, {"round", LineCap::round}, {"square", LineCap::square}};
    return assign_keyword(style.cap, value, keywords);
}

bool apply_join(SvgStyle& style, std::string_view value, const UnitContext&) {
    // The two newer keywords are drawn as mitres, as renderers without them do.
    static constexpr std::pair<std::string_view, LineJoin> keywords[] = {{"miter", LineJoin::miter},
                                                                         {"round", LineJoin::round},
                                                                         {"bevel", LineJoin::bevel},
                                                                         {"miter-clip", LineJoin::miter},
                                                                         {"arcs", LineJoin::miter}};
    return assign_keyword(style.join, value, keywords);
}

bool apply_miter_limit(SvgStyle& style, std::string_view value, const UnitContext&) {
    const auto limit = parse_number(value);
    if (!limit || *limit < 1) return false;
    style.miter_limit = *limit;
    return true;
}

bool apply_dashes(SvgStyle& style, std::string_view value, const UnitContext& units) {
    if (value == "none") {
        style.dashes.clear();
        return true;
    }
    auto dashes = parse_lengths(value, units, LengthAxis::diagonal);
    if (!dashes || std::ranges::any_of(*dashes, [](double dash) { return dash < 0; })) return false;
    const std::size_t count = dashes->size();
    if (count % 2 == 1) {
        dashes->reserve(2 * count);
        for (std::size_t i = 0; i < count; ++i) dashes->push_back((*dashes)[i]);
    }
    // Dashes without length anywhere mean a solid line.
    if (std::accumulate(dashes->begin(), dashes->end(), 0.0) <= 0) dashes->clear();
    style.dashes = std::move(*dashes);
    return true;
}

bool apply_paint_order(SvgStyle& style, std::string_view value, const UnitContext&) {
    std::vector<PaintPart> order;
    const auto add = [&](PaintPart part) {
        if (std::ranges::find(order, part) == order.end()) order.push_back(part);
    };
    TextCursor cursor{value};
    skip_space(cursor);
    while (!cursor.at_end()) {
        if (skip_token(cursor, "fill"))
            add(PaintPart::fill);
        else if (skip_token(cursor, "stroke"))
            add(PaintPart::stroke);
        else if (skip_token(cursor, "markers"))
            add(PaintPart::markers);
        else if (!skip_token(cursor, "normal"))
            return false;
        skip_space(cursor);
    }
    for (const PaintPart part : {PaintPart::fill, PaintPart::stroke, PaintPart::markers}) add(part);
    std::ranges::copy(order, style.paint_order.begin());
    return true;
}

bool apply_visibility(SvgStyle& style, std::string_view value, const UnitContext&) {
    static constexpr std::pair<std::string_view, bool> keywords[] = {
        {"visible", true}, {"hidden", false}, {"collapse", false}};
    return assign_keyword(style.visible, value, keywords);
}

bool apply_rendering(SvgStyle& style, std::string_view value, const UnitContext&) {
    static constexpr std::pair<std::string_view, bool> keywords[] = {
        {"auto", false}, {"geometricprecision", false}, {"crispedges", true}, {"optimizespeed", true}};
    return assign_keyword(style.crisp_edges, lower_case(value), keywords);
}

bool apply_overflow(SvgStyle& style, std::string_view value, const UnitContext&) {
    if (value == "visible" || value == "auto")
        style.overflow_visible = true;
    else if (value == "hidden" || value == "scroll" || value == "clip")
        style.overflow_visible = false;
    else
        return false;
    return true;
}

bool apply_marker(SvgStyle& style, std::string_view value, const UnitContext&) {
    std::string reference;
    if (!assign_reference(reference, value)) return false;
    style.marker_start = style.marker_mid = style.marker_end = reference;
    return true;
}

/// The size in the shorthand "italic bold 12px/1.5 serif": the first length in it, before any "/".
bool apply_font(SvgStyle& style, std::string_view value, const UnitContext& units) {
    std::size_t begin = 0;
    while (begin < value.size()) {
        const std::size_t end = std::min(value.find_first_of(" /", begin), value.size());
        const std::string_view word = value.substr(begin, end - begin);
        // A bare number is a weight.
        if (!word.empty() && !parse_number(word))
            if (const auto size = parse_font_size(word, units)) {
                style.font_size = *size;
                return true;
            }
        begin = end + 1;
    }
    return false;
}

using S = SvgStyle;
using V = std::string_view;
using U = UnitContext;

constexpr auto properties = std::to_array<Property>({
    {"font", apply_font, [](S& s, const S& p) { s.font_size = p.font_size; }},
    {"font-size", [](S& s, V v, const U& u) { return assign(s.font_size, parse_font_size(v, u)); },
     [](S& s, const S& p) { s.font_size = p.font_size; }},
    {"color", apply_color, [](S& s, const S& p) { s.color = p.color; }},
    {"fill", [](S& s, V v, const U&) { return assign(s.fill, parse_paint(v)); }, [](S& s, const S& p) { s.fill = p.fill; }},
    {"stroke", [](S& s, V v, const U&) { return assign(s.stroke, parse_paint(v)); },
     [](S& s, const S& p) { s.stroke = p.stroke; }},
    {"fill-opacity", [](S& s, V v, const U&) { return assign(s.fill_opacity, parse_opacity(v)); },
     [](S& s, const S& p) { s.fill_opacity = p.fill_opacity; }},
    {"stroke-opacity", [](S& s, V v, const U&) { return assign(s.stroke_opacity, parse_opacity(v)); },
     [](S& s, const S& p) { s.stroke_opacity = p.stroke_opacity; }},
    {"fill-rule", [](S& s, V v, const U&) { return assign_rule(s.fill_rule, v); },
     [](S& s, const S& p) { s.fill_rule = p.fill_rule; }},
    {"clip-rule", [](S& s, V v, const U&) { return assign_rule(s.clip_rule, v); },
     [](S& s, const S& p) { s.clip_rule = p.clip_rule; }},
    {"stroke-width", apply_width, [](S& s, const S& p) { s.stroke_width = p.stroke_width; }},
    {"stroke-linecap", apply_cap, [](S& s, const S& p) { s.cap = p.cap; }},
    {"stroke-linejoin", apply_join, [](S& s, const S& p) { s.join = p.join; }},
    {"stroke-miterlimit", apply_miter_limit, [](S& s, const S& p) { s.miter_limit = p.miter_limit; }},
    {"stroke-dasharray", apply_dashes, [](S& s, const S& p) { s.dashes = p.dashes; }},
    {"stroke-dashoffset",
     [](S& s, V v, const U& u) { return assign(s.dash_offset, parse_length(v, u, LengthAxis::diagonal)); },
     [](S& s, const S& p) { s.dash_offset = p.dash_offset; }},
    {"marker", apply_marker,
     [](S& s, const S& p) { s.marker_start = p.marker_start, s.marker_mid = p.marker_mid, s.marker_end = p.marker_end; }},
    {"marker-start", [](S& s, V v, const U&) { return assign_reference(s.marker_start, v); },
     [](S& s, const S& p) { s.marker_start = p.marker_start; }},
    {"marker-mid", [](S& s, V v, const U&) { return assign_reference(s.marker_mid, v); },
     [](S& s, const S& p) { s.marker_mid = p.marker_mid; }},
    {"marker-end", [](S& s, V v, const U&) { return assign_reference(s.marker_end, v); },
     [](S& s, const S& p) { s.marker_end = p.marker_end; }},
    {"paint-order", apply_paint_order, [](S& s, const S& p) { s.paint_order = p.paint_order; }},
    {"visibility", apply_visibility, [](S& s, const S& p) { s.visible = p.visible; }},
    {"shape-rendering", apply_rendering, [](S& s, const S& p) { s.crisp_edges = p.crisp_edges; }},
    {"display", [](S& s, V v, const U&) { return s.displayed = v != "none", true; },
     [](S& s, const S& p) { s.displayed = p.displayed; }},
    {"opacity", [](S& s, V v, const U&) { return assign(s.opacity, parse_opacity(v)); },
     [](S& s, const S& p) { s.opacity = p.opacity; }},
    {"clip-path", [](S& s, V v, const U&) { return assign_effect(s.clip_path, v); },
     [](S& s, const S& p) { s.clip_path = p.clip_path; }},
    {"mask", [](S& s, V v, const U&) { return assign_effect(s.mask, v); }, [](S& s, const S& p) { s.mask = p.mask; }},
    {"filter", [](S& s, V v, const U&) { return assign_effect(s.filter, v); },
     [](S& s, const S& p) { s.filter = p.filter; }},
    {"overflow", apply_overflow, [](S& s, const S& p) { s.overflow_visible = p.overflow_visible; }},
    {"vector-effect", [](S& s, V v, const U&) { return s.non_scaling_stroke = v == "non-scaling-stroke", true; },
     [](S& s, const S& p) { s.non_scaling_stroke = p.non_scaling_stroke; }},
    {"mix-blend-mode", [](S& s, V v, const U&) { return s.blended = v != "normal", true; },
     [](S& s, const S& p) { s.blended = p.blended; }},
    {"isolation", [](S& s, V v, const U&) { return s.isolated = v == "isolate", true; },
     [](S& s, const S& p) { s.isolated = p.isolated; }},
    {"transform", [](S& s, V v, const U&) { return assign_effect(s.transform, v); },
     [](S& s, const S& p) { s.transform = p.transform; }},
    {"transform-origin", [](S& s, V v, const U&) { return assign_effect(s.transform_origin, v); },
     [](S& s, const S& p) { s.transform_origin = p.transform_origin; }},
    {"transform-box",
     [](S& s, V v, const U&) { return s.fill_box = v == "fill-box" || v == "stroke-box" || v == "content-box", true; },
     [](S& s, const S& p) { s.fill_box = p.fill_box; }},
    {"stop-color", [](S& s, V v, const U&) { return assign(s.stop_color, parse_color(v)); },
     [](S& s, const S& p) { s.stop_color = p.stop_color; }},
    {"stop-opacity", [](S& s, V v, const U&) { return assign(s.stop_opacity, parse_opacity(v)); },
     [](S& s, const S& p) { s.stop_opacity = p.stop_opacity; }},
});

/// By name, which is also the order to apply them in: font sizes before the lengths, shorthands before their parts.
constexpr auto properties_by_name = [] {
    auto sorted = properties;
    std::ranges::sort(sorted, {}, &Property::name);
    return sorted;
}();

/// What a child starts from: the inherited half of its parent's style, the initial values of the rest.
SvgStyle inherited_part(const SvgStyle& parent) {
    SvgStyle style = parent;
    style.displayed = true;
    style.opacity = 1;
    style.clip_path.clear();
    style.mask.clear();
    style.filter.clear();
    style.overflow_visible.reset();
    style.non_scaling_stroke = style.blended = style.isolated = style.fill_box = false;
    style.transform.clear();
    style.transform_origin.clear();
    style.stop_color = {};
    style.stop_opacity = 1;
    style.faults.clear();
    return style;
}

void apply_initial(SvgStyle& style, const Property& property) {
    static const SvgStyle initial;
    property.inherit(style, initial);
}

constexpr std::string_view inherited_properties[] = {"clip-rule",
                                                     "color",
                                                     "color-interpolation",
                                                     "color-interpolation-filters",
                                                     "color-rendering",
                                                     "cursor",
                                                     "direction",
                                                     "dominant-baseline",
                                                     "fill",
                                                     "fill-opacity",
                                                     "fill-rule",
                                                     "font",
                                                     "font-family",
                                                     "font-feature-settings",
                                                     "font-size",
                                                     "font-size-adjust",
                                                     "font-stretch",
                                                     "font-style",
                                                     "font-variant",
                                                     "font-weight",
                                                     "glyph-orientation-horizontal",
                                                     "glyph-orientation-vertical",
                                                     "image-rendering",
                                                     "kerning",
                                                     "letter-spacing",
                                                     "line-height",
                                                     "marker",
                                                     "marker-end",
                                                     "marker-mid",
                                                     "marker-start",
                                                     "paint-order",
                                                     "pointer-events",
                                                     "shape-rendering",
                                                     "stroke",
                                                     "stroke-dasharray",
                                                     "stroke-dashoffset",
                                                     "stroke-linecap",
                                                     "stroke-linejoin",
                                                     "stroke-miterlimit",
                                                     "stroke-opacity",
                                                     "stroke-width",
                                                     "text-align",
                                                     "text-anchor",
                                                     "text-indent",
                                                     "text-orientation",
                                                     "text-rendering",
                                                     "visibility",
                                                     "white-space",
                                                     "word-spacing",
                                                     "writing-mode"};

constexpr std::string_view own_properties[] = {"alignment-baseline", "baseline-shift",  "clip-path",   "display",
                                               "enable-background",  "filter",          "flood-color", "flood-opacity",
                                               "isolation",          "lighting-color",  "mask",        "mask-type",
                                               "mix-blend-mode",     "opacity",         "overflow",    "stop-color",
                                               "stop-opacity",       "text-decoration", "transform",   "transform-origin",
                                               "unicode-bidi",       "vector-effect"};

const Property* find_property(std::string_view name) {
    const auto found = std::ranges::lower_bound(properties_by_name, name, {}, &Property::name);
    return found != properties_by_name.end() && found->name == name ? &*found : nullptr;
}

bool is_css_wide(std::string_view value) {
    return value == "inherit" || value == "initial" || value == "unset" || value == "revert";
}

}  // namespace

bool is_understood(std::string_view property, std::string_view value) {
    const Property* known = find_property(property);
    SvgStyle scratch;
    return known == nullptr || is_css_wide(value) || known->apply(scratch, value, UnitContext{});
}

SvgStyle computed_style(const SpecifiedStyle& specified, const SvgStyle& parent, const UnitContext& units) {
    SvgStyle style = inherited_part(parent);
    if (specified.empty()) return style;
    UnitContext own_units = units;
    for (const auto& [name, value] : specified) {
        const Property* property = find_property(name);
        if (property == nullptr) continue;
        if (value == "inherit")
            property->inherit(style, parent);
        else if (value == "initial")
            apply_initial(style, *property);
        else if (!is_css_wide(value) && !property->apply(style, value, own_units))
            style.faults.emplace_back(name, value);
        own_units.font_size = style.font_size;
    }
    return style;
}

ParsedColor resolved_color(const ParsedColor& color, const SvgStyle& style) { return color.current ? style.color : color; }

bool is_inherited_property(std::string_view name) { return std::ranges::binary_search(inherited_properties, name); }

bool is_presentation_attribute(std::string_view name) {
    // The shorthands exist in CSS only.
    if (name == "font" || name == "marker") return false;
    return is_inherited_property(name) || std::ranges::binary_search(own_properties, name);
}

}  // namespace rinceau
