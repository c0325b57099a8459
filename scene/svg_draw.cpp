#include "scene/svg_draw.h"

#include <algorithm>
#include <array>

#include "scene/svg_attribute_check.h"
#include "scene/svg_effects.h"
#include "scene/svg_number.h"
#include "scene/svg_outline.h"
#include "scene/svg_shape.h"
#include "scene/svg_use.h"
#include "scene/svg_verbatim.h"
#include "scene/svg_viewport.h"

namespace rinceau {
namespace {

enum class NodeKind : std::uint8_t {
    shape,
    group,
    nested_svg,
    use,
    choice,
    text,
    image,
    foreign,
    silent,
    animation,
    flow_text,
    unknown
};

struct NamedKind {
    std::string_view name;
    NodeKind kind;
};

constexpr auto node_kinds = [] {
    auto kinds = std::to_array<NamedKind>({
        {"path", NodeKind::shape},
        {"rect", NodeKind::shape},
        {"circle", NodeKind::shape},
        {"ellipse", NodeKind::shape},
        {"line", NodeKind::shape},
        {"polyline", NodeKind::shape},
        {"polygon", NodeKind::shape},
        {"g", NodeKind::group},
        {"a", NodeKind::group},
        {"svg", NodeKind::nested_svg},
        {"use", NodeKind::use},
        {"switch", NodeKind::choice},
        {"text", NodeKind::text},
        {"image", NodeKind::image},
        {"foreignObject", NodeKind::foreign},
        // Definitions and remarks: they draw through others or not at all.
        {"defs", NodeKind::silent},
        {"symbol", NodeKind::silent},
        {"clipPath", NodeKind::silent},
        {"mask", NodeKind::silent},
        {"pattern", NodeKind::silent},
        {"marker", NodeKind::silent},
        {"linearGradient", NodeKind::silent},
        {"radialGradient", NodeKind::silent},
        {"filter", NodeKind::silent},
        {"style", NodeKind::silent},
        {"script", NodeKind::silent},
        {"title", NodeKind::silent},
        {"desc", NodeKind::silent},
        {"metadata", NodeKind::silent},
        {"view", NodeKind::silent},
        {"cursor", NodeKind::silent},
        {"font", NodeKind::silent},
        {"font-face", NodeKind::silent},
        {"color-profile", NodeKind::silent},
        {"stop", NodeKind::silent},
        {"solidColor", NodeKind::silent},
        {"animate", NodeKind::animation},
        {"set", NodeKind::animation},
        {"animateTransform", NodeKind::animation},
        {"animateMotion", NodeKind::animation},
        {"animateColor", NodeKind::animation},
        {"flowRoot", NodeKind::flow_text},
    });
    std::ranges::sort(kinds, {}, &NamedKind::name);
    return kinds;
}();

NodeKind kind_of(const SvgNode& node) {
    const auto found = std::ranges::lower_bound(node_kinds, node.name, {}, &NamedKind::name);
    return found != node_kinds.end() && found->name == node.name ? found->kind : NodeKind::unknown;
}

bool has_characters(const SvgNode& node) {
    for (const SvgNode* child = node.first_child; child != nullptr; child = child->next)
        if (is_text(*child) ? !trimmed(child->text).empty() : child->name == "tref" || has_characters(*child)) return true;
    return false;
}

/// Where an image may draw: its box, as far as it says.
Box image_box(const SvgContext& context) {
    const double x = length_of(context, "x", LengthAxis::x, 0), y = length_of(context, "y", LengthAxis::y, 0);
    const double width = length_of(context, "width", LengthAxis::x, 0),
                 height = length_of(context, "height", LengthAxis::y, 0);
    if (!(width > 0) || !(height > 0) || context.style.overflow_visible.value_or(false)) return {};
    const Affine map = scene_map(context);
    Box box;
    for (const Point corner : {Point{x, y}, {x + width, y}, {x, y + height}, {x + width, y + height}})
        box = including(box, apply(map, corner));
    return box;
}

void keep_image(SvgReader& reader, const SvgContext& context) {
    if (!context.style.visible) return;
    const std::string_view reference = href_of(*context.node);
    if (reference.empty()) return;
    const bool own = reference.starts_with("data:") || reference.starts_with('#');
    keep_verbatim(reader, context, image_box(context),
                  own ? "{} image elements are kept as they are"
                      : "{} image elements are kept as they are; they show other files, which must stay reachable");
}

void draw_content(SvgReader& reader, SvgContext& context, NodeKind kind) {
    switch (kind) {
        case NodeKind::shape:
            return draw_shape(reader, context);
        case NodeKind::group:
            return draw_children(reader, context);
        case NodeKind::nested_svg:
            return draw_nested_svg(reader, context);
        case NodeKind::use:
            return draw_use(reader, context);
        case NodeKind::choice:
            return draw_switch(reader, context);
        case NodeKind::text:
            if (has_characters(*context.node)) keep_verbatim(reader, context, {}, "{} text elements are kept as they are");
            return;
        case NodeKind::image:
            return keep_image(reader, context);
        case NodeKind::foreign:
            return keep_verbatim(reader, context, {},
                                 "{} foreignObject elements are kept as they are; many programs do not show them");
        default:
            return;
    }
}

/// Kept parts hold their own effects already.
bool is_kept_whole(NodeKind kind) { return kind == NodeKind::text || kind == NodeKind::image || kind == NodeKind::foreign; }

void note_undrawn(SvgReader& reader, const SvgNode& node, NodeKind kind) {
    if (kind == NodeKind::animation) reader.warnings.add("{} animations are left out: the drawing stands still", node);
    if (kind == NodeKind::flow_text)
        reader.warnings.add("{} flowRoot elements (never part of a standard) are left out, as browsers do", node);
    if (kind == NodeKind::unknown) reader.warnings.add("{} elements with names that SVG does not know are left out", node);
}

struct RootSize {
    double width = 0, height = 0;
    bool sized = true;
};

/// CSS sizes of the root: lengths as given; a missing or relative one follows from the view box and the other one.
RootSize root_size(const SvgReader& reader, const SvgContext& root, const std::optional<ViewBox>& box) {
    const auto given = [&](std::string_view name, LengthAxis axis) -> std::optional<double> {
        std::string_view text;
        if (const std::string_view* value = find_attribute(*root.node, name)) text = trimmed(*value);
        if (const std::string* value = find_value(root.specified, name)) text = *value;
        if (text.empty() || text.ends_with('%')) return std::nullopt;
        const auto length = parse_length(text, root.units, axis);
        return length && *length > 0 ? length : std::nullopt;
    };
    const auto width = given("width", LengthAxis::x), height = given("height", LengthAxis::y);
    const bool boxed = box && box->width > 0 && box->height > 0;
    if (width && height) return {*width, *height};
    if (boxed && width) return {*width, *width * box->height / box->width};
    if (boxed && height) return {*height * box->width / box->height, *height};
    if (boxed && reader.options.width > 0 && reader.options.height > 0) return {reader.options.width, reader.options.height};
    if (boxed) return {box->width, box->height};
    const double all_width = reader.options.width > 0 ? reader.options.width : 100;
    const double all_height = reader.options.height > 0 ? reader.options.height : 100;
    return {width.value_or(all_width), height.value_or(all_height), width || height};
}

Box box_of_all(const Scene& scene) {
    Box box;
    for (const Element& element : scene.elements) box = including(box, painted_box(element));
    return box;
}

}  // namespace

void draw_children(SvgReader& reader, const SvgContext& context) {
    for (const SvgNode* child = context.node->first_child; child != nullptr; child = child->next)
        if (!is_text(*child)) draw_node(reader, context, *child);
}

void draw_node(SvgReader& reader, const SvgContext& parent, const SvgNode& node) {
    if (!is_svg(node) || !passes_conditions(node)) return;
    const NodeKind kind = kind_of(node);
    if (kind >= NodeKind::silent) return note_undrawn(reader, node, kind);
    SvgContext context = enter(reader, parent, node);
    if (!context.style.displayed) return;
    check_attributes(reader, node, context.specified);
    if (determinant(context.map) == 0) {
        reader.warnings.add("{} elements with a transform that flattens them are left out", node);
        return;
    }
    const SvgOpening opening(reader, node);
    const SvgMark mark = mark_of(reader);
    draw_content(reader, context, kind);
    if (!is_kept_whole(kind))
        finish_effects(reader, context, mark);
    else if (context.style.blended)
        ++reader.blended;
}

std::optional<SvgContext> enter_root(SvgReader& reader) {
    const SvgNode& root = reader.tree.root();
    SvgContext page;
    page.depth = 0;
    SvgContext context = enter(reader, page, root);
    context.parent = nullptr;
    check_attributes(reader, root, context.specified);
    std::optional<ViewBox> box;
    if (const std::string_view* text = find_attribute(root, "viewBox")) box = parse_view_box(*text);
    const RootSize size = root_size(reader, context, box);
    reader.scene.sized = size.sized;
    reader.scene.viewport = {{0, -size.height}, {size.width, 0}};
    reader.tolerance = invisible_share * diagonal(reader.scene.viewport);
    UnitContext& units = context.units;
    units.width = units.page_width = size.width;
    units.height = units.page_height = size.height;
    units.root_font_size = units.font_size;
    if (box) {
        AspectRatio aspect;
        if (const std::string_view* text = find_attribute(root, "preserveAspectRatio"))
            aspect = parse_aspect_ratio(*text).value_or(aspect);
        if (!(box->width > 0) || !(box->height > 0)) return std::nullopt;
        context.map = context.map * view_box_map(*box, aspect, size.width, size.height);
        units.width = box->width;
        units.height = box->height;
    }
    reader.root_units = units;
    return context.style.displayed ? std::optional(context) : std::nullopt;
}

void draw_root(SvgReader& reader) {
    const std::optional<SvgContext> context = enter_root(reader);
    if (!context) return;
    const SvgOpening opening(reader, reader.tree.root());
    const SvgMark mark = mark_of(reader);
    draw_children(reader, *context);
    finish_effects(reader, *context, mark);
    if (!reader.scene.sized) reader.scene.viewport = box_of_all(reader.scene);
}

bool is_drawn_kind(const SvgNode& node) { return is_svg(node) && kind_of(node) < NodeKind::silent; }

bool is_undrawn_content(const SvgNode& node) {
    return is_svg(node) && (kind_of(node) == NodeKind::flow_text || kind_of(node) == NodeKind::unknown);
}

}  // namespace rinceau
