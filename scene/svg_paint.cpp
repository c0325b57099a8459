#include "scene/svg_paint.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>

#include "scene/svg_attribute_check.h"
#include "scene/svg_number.h"
#include "scene/svg_transform.h"

namespace rinceau {
namespace {

// A focus on the circle's edge has no gradient about it: it is moved inside by this share of the radius.
constexpr double focus_margin = 1e-3;

// Gradients that refer to one another; drawings have two or three in a row, and longer chains cost time for each gradient.
constexpr std::size_t longest_chain = 200;

bool is_gradient(const SvgNode& node) {
    return is_svg(node) && (node.name == "linearGradient" || node.name == "radialGradient");
}

/// The gradient and the ones that it refers to, nearest first; ends at the first that is no gradient or comes twice.
std::vector<const SvgNode*> reference_chain(SvgReader& reader, const SvgNode& node) {
    std::vector<const SvgNode*> chain;
    std::unordered_set<const SvgNode*> seen;
    for (const SvgNode* link = &node; link != nullptr && is_gradient(*link); link = find_reference(reader, href_of(*link))) {
        if (!seen.insert(link).second) {
            reader.warnings.add("{} references that lead back to themselves are skipped", node);
            break;
        }
        if (chain.size() == longest_chain) {
            reader.warnings.add("{} gradients refer to one another more than 200 times in a row; the rest is skipped", node);
            break;
        }
        chain.push_back(link);
    }
    return chain;
}

std::string_view inherited_attribute(const std::vector<const SvgNode*>& chain, std::string_view name) {
    for (const SvgNode* link : chain)
        if (const std::string_view* value = find_attribute(*link, name)) return trimmed(*value);
    return {};
}

/// Geometry passes only between gradients of the same kind.
std::string_view inherited_geometry(const std::vector<const SvgNode*>& chain, std::string_view name) {
    for (const SvgNode* link : chain)
        if (link->name == chain.front()->name)
            if (const std::string_view* value = find_attribute(*link, name)) return trimmed(*value);
    return {};
}

bool has_stops(const SvgNode& node) {
    for (const SvgNode* child = node.first_child; child != nullptr; child = child->next)
        if (is_svg(*child) && child->name == "stop") return true;
    return false;
}

std::vector<GradientStop> read_stops(SvgReader& reader, const SvgNode& gradient) {
    std::vector<std::unique_ptr<SvgContext>> above = ancestor_contexts(reader, gradient);
    const SvgContext owner = enter(reader, *above.back(), gradient);
    std::vector<GradientStop> stops;
    for (const SvgNode* child = gradient.first_child; child != nullptr; child = child->next) {
        if (!is_svg(*child) || child->name != "stop") continue;
        const SvgContext context = enter(reader, owner, *child);
        check_attributes(reader, *child, context.specified);
        const SvgStyle& style = context.style;
        const ParsedColor color = resolved_color(style.stop_color, style);
        double offset = 0;
        if (const std::string_view* value = find_attribute(*child, "offset"))
            offset = parse_share(trimmed(*value)).value_or(0);
        offset = std::clamp(offset, stops.empty() ? 0.0 : stops.back().offset, 1.0);
        stops.push_back({offset, color.color, color.opacity * style.stop_opacity});
    }
    return stops;
}

GradientSpread spread_of(std::string_view text) {
    if (text == "reflect") return GradientSpread::reflect;
    return text == "repeat" ? GradientSpread::repeat : GradientSpread::pad;
}

SvgGradientDefinition read_definition(SvgReader& reader, const SvgNode& node) {
    const std::vector<const SvgNode*> chain = reference_chain(reader, node);
    for (const SvgNode* link : chain) check_attributes(reader, *link, {});
    SvgGradientDefinition definition;
    definition.kind = node.name == "linearGradient" ? GradientKind::linear : GradientKind::radial;
    definition.spread = spread_of(inherited_attribute(chain, "spreadMethod"));
    definition.user_space = inherited_attribute(chain, "gradientUnits") == "userSpaceOnUse";
    const std::string_view transform = inherited_attribute(chain, "gradientTransform");
    if (const ParsedTransform parsed = parse_transform_attribute(transform); parsed.map) {
        definition.transform = *parsed.map;
    } else {
        note_fault(reader, node, "gradientTransform", transform, "it is left out");
    }
    using Geometry = std::pair<std::string_view, std::string_view SvgGradientDefinition::*>;
    using D = SvgGradientDefinition;
    for (const auto& [name, field] : {Geometry{"x1", &D::x1},
                                      {"y1", &D::y1},
                                      {"x2", &D::x2},
                                      {"y2", &D::y2},
                                      {"cx", &D::cx},
                                      {"cy", &D::cy},
                                      {"r", &D::r},
                                      {"fx", &D::fx},
                                      {"fy", &D::fy},
                                      {"fr", &D::fr}})
        definition.*field = inherited_geometry(chain, name);
    const auto source = std::ranges::find_if(chain, [](const SvgNode* link) { return has_stops(*link); });
    if (source != chain.end()) definition.stops = read_stops(reader, **source);
    return definition;
}

const SvgGradientDefinition& definition_of(SvgReader& reader, const SvgNode& node) {
    auto& cached = reader.gradients[&node];
    if (!cached) cached = std::make_shared<const SvgGradientDefinition>(read_definition(reader, node));
    return *cached;
}

/// In units of the box, 100 % and 1 are its side.
constexpr UnitContext box_units{.width = 1, .height = 1};

struct GradientFrame {
    Affine map;  ///< from the unit gradient to gradient space
    Point focus;
    double focal_radius = 0;
    bool degenerate = false;     ///< no extent: the last stop's colour everywhere
    bool focus_outside = false;  ///< the focal circle leaves the circle: a cone
};

GradientFrame linear_frame(const SvgGradientDefinition& d, const UnitContext& units) {
    const auto value = [&](std::string_view text, LengthAxis axis, std::string_view fallback) {
        return parse_length(text, units, axis).value_or(*parse_length(fallback, units, axis));
    };
    const Point from{value(d.x1, LengthAxis::x, "0%"), value(d.y1, LengthAxis::y, "0%")};
    const Point along = Point{value(d.x2, LengthAxis::x, "100%"), value(d.y2, LengthAxis::y, "0%")} - from;
    return {{along.x, along.y, -along.y, along.x, from.x, from.y}, {}, 0, norm(along) == 0, false};
}

GradientFrame radial_frame(const SvgGradientDefinition& d, const UnitContext& units) {
    const auto value = [&](std::string_view text, LengthAxis axis, double fallback) {
        return parse_length(text, units, axis).value_or(fallback);
    };
    const auto half = [&](LengthAxis axis) { return *parse_length("50%", units, axis); };
    const Point center{value(d.cx, LengthAxis::x, half(LengthAxis::x)), value(d.cy, LengthAxis::y, half(LengthAxis::y))};
    double radius = value(d.r, LengthAxis::diagonal, half(LengthAxis::diagonal));
    if (radius < 0) radius = half(LengthAxis::diagonal);
    if (radius == 0) return {.degenerate = true};
    Point focus = (Point{value(d.fx, LengthAxis::x, center.x), value(d.fy, LengthAxis::y, center.y)} - center) / radius;
    const double focal_share = std::max(0.0, value(d.fr, LengthAxis::diagonal, 0) / radius);
    const bool outside = abs(focus) > 1 || (focal_share > 0 && abs(focus) + focal_share > 1);
    if (abs(focus) > 1 - focus_margin) focus = focus * ((1 - focus_margin) / abs(focus));
    const double focal_radius = std::min(focal_share, 1 - focus_margin);
    return {{radius, 0, 0, radius, center.x, center.y}, focus, focal_radius, false, outside};
}

SvgPaint solid(const Color& color, double opacity) { return {color, opacity, false}; }

SvgPaint resolve_color(const ParsedColor& parsed, const SvgContext& context) {
    const ParsedColor color = resolved_color(parsed, context.style);
    return solid(color.color, color.opacity);
}

/// Nothing if the gradient cannot be laid out on this shape (then the fallback holds).
std::optional<SvgPaint> resolve_gradient(SvgReader& reader, const SvgContext& context, const SvgNode& node, const Box& box) {
    const SvgGradientDefinition& definition = definition_of(reader, node);
    if (definition.stops.empty()) return SvgPaint{};
    const GradientStop& last = definition.stops.back();
    if (definition.stops.size() == 1) return solid(last.color, last.opacity);
    Affine map = scene_map(context);
    if (!definition.user_space) {
        // A box without area has no units.
        if (!(width(box) > 0) || !(height(box) > 0)) return std::nullopt;
        map = map * Affine{width(box), 0, 0, height(box), box.low.x, box.low.y};
    }
    const UnitContext& units = definition.user_space ? context.units : box_units;
    const GradientFrame frame =
        definition.kind == GradientKind::linear ? linear_frame(definition, units) : radial_frame(definition, units);
    map = map * definition.transform;
    if (determinant(map) == 0) return SvgPaint{};
    if (frame.degenerate) return solid(last.color, last.opacity);
    // Renderers differ on these, and a style cannot hold them.
    if (frame.focus_outside) return SvgPaint{NoPaint{}, 1, true};
    Gradient gradient{definition.kind, definition.spread, definition.stops,
                      map * frame.map, frame.focus,       frame.focal_radius};
    return SvgPaint{std::make_shared<const Gradient>(std::move(gradient)), 1, false};
}

SvgPaint resolve_fallback(const SvgContext& context, const ParsedPaint& paint) {
    if (!paint.has_fallback || paint.fallback == PaintKind::none) return {};
    return resolve_color(paint.fallback_color, context);
}

SvgPaint resolve_reference(SvgReader& reader, const SvgContext& context, const ParsedPaint& paint, const Box& box) {
    const SvgNode* server = find_reference(reader, paint.reference);
    if (server != nullptr && is_gradient(*server)) {
        const auto gradient = resolve_gradient(reader, context, *server, box);
        return gradient ? *gradient : resolve_fallback(context, paint);
    }
    if (server != nullptr && is_svg(*server) && server->name == "pattern") return {NoPaint{}, 1, true};
    reader.warnings.add("{} paints refer to a gradient or pattern that does not exist", *context.node);
    return resolve_fallback(context, paint);
}

}  // namespace

SvgPaint resolve_paint(SvgReader& reader, const SvgContext& context, const ParsedPaint& paint, const Box& box) {
    switch (paint.kind) {
        case PaintKind::none:
            return {};
        case PaintKind::color:
            return resolve_color(paint.color, context);
        case PaintKind::reference:
            return resolve_reference(reader, context, paint, box);
        case PaintKind::context_fill:
            if (context.context_style == nullptr) return {};
            return {context.context_style->fill, context.context_style->fill_opacity, false};
        case PaintKind::context_stroke:
            if (context.context_style == nullptr) return {};
            return {context.context_style->stroke.paint, context.context_style->stroke.opacity, false};
    }
    return {};
}

}  // namespace rinceau
