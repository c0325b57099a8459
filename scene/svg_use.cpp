#include "scene/svg_use.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <vector>

#include "scene/svg_attribute_check.h"
#include "scene/svg_clip.h"
#include "scene/svg_draw.h"
#include "scene/svg_effects.h"
#include "scene/svg_number.h"
#include "scene/svg_outline.h"
#include "scene/svg_viewport.h"

namespace rinceau {
namespace {

Affine translation(double x, double y) { return {1, 0, 0, 1, x, y}; }

AspectRatio aspect_of(const SvgNode& node) {
    const std::string_view* text = find_attribute(node, "preserveAspectRatio");
    return text == nullptr ? AspectRatio{} : parse_aspect_ratio(*text).value_or(AspectRatio{});
}

/// Moves the context into the viewport of a symbol or svg whose corner is at the origin and draws its children, clipped to
/// it unless it lets them overflow.
void draw_in_viewport(SvgReader& reader, SvgContext& context, double width, double height) {
    if (!(width > 0) || !(height > 0)) return;
    const Affine outside = context.map;
    context.units.width = width;
    context.units.height = height;
    if (const std::string_view* text = find_attribute(*context.node, "viewBox"))
        if (const auto box = parse_view_box(*text)) {
            if (!(box->width > 0) || !(box->height > 0)) return;
            context.map = context.map * view_box_map(*box, aspect_of(*context.node), width, height);
            context.units.width = box->width;
            context.units.height = box->height;
        }
    const std::size_t first = reader.scene.elements.size();
    draw_children(reader, context);
    if (context.style.overflow_visible.value_or(false)) return;
    clip_to_polygon(reader, first, outside, {{0, 0}, {width, 0}, {width, height}, {0, height}}, *context.node);
}

/// A size given on the use element, else on its target, else all of the viewport around.
double viewport_size(const SvgContext& use, const SvgContext& target, std::string_view name, LengthAxis axis) {
    const double all = axis == LengthAxis::x ? use.units.width : use.units.height;
    return length_of(use, name, axis, length_of(target, name, axis, all));
}

void draw_used_viewport(SvgReader& reader, const SvgContext& use, const SvgNode& target) {
    SvgContext context = enter(reader, use, target);
    if (!context.style.displayed) return;
    check_attributes(reader, target, context.specified);
    const SvgOpening opening(reader, target);
    const SvgMark mark = mark_of(reader);
    const double width = viewport_size(use, context, "width", LengthAxis::x);
    const double height = viewport_size(use, context, "height", LengthAxis::y);
    if (target.name == "svg")
        context.map =
            context.map * translation(length_of(context, "x", LengthAxis::x, 0), length_of(context, "y", LengthAxis::y, 0));
    draw_in_viewport(reader, context, width, height);
    finish_effects(reader, context, mark);
}

std::vector<std::string_view> words_of(std::string_view text, char separator) {
    std::vector<std::string_view> words;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(separator, begin), text.size());
        words.push_back(trimmed(text.substr(begin, end - begin)));
        begin = end + 1;
    }
    return words;
}

/// Features of SVG 1.1 (appendix O) that a picture at rest has.
bool is_feature_of_pictures(std::string_view feature) {
    constexpr std::string_view prefix = "http://www.w3.org/TR/SVG11/feature#";
    static constexpr std::string_view names[] = {"SVG",
                                                 "SVG-static",
                                                 "SVGDOM-static",
                                                 "Structure",
                                                 "BasicStructure",
                                                 "ContainerAttribute",
                                                 "ConditionalProcessing",
                                                 "Image",
                                                 "Style",
                                                 "View",
                                                 "ViewportAttribute",
                                                 "Shape",
                                                 "BasicText",
                                                 "PaintAttribute",
                                                 "BasicPaintAttribute",
                                                 "OpacityAttribute",
                                                 "GraphicsAttribute",
                                                 "BasicGraphicsAttribute",
                                                 "Marker",
                                                 "Gradient",
                                                 "Pattern",
                                                 "Clip",
                                                 "BasicClip",
                                                 "Mask",
                                                 "Filter",
                                                 "BasicFilter"};
    return feature.starts_with(prefix) && std::ranges::find(names, feature.substr(prefix.size())) != std::end(names);
}

bool is_english(std::string_view word) {
    const std::string language = lower_case(word);
    return language == "en" || language.starts_with("en-");
}

}  // namespace

bool passes_conditions(const SvgNode& node) {
    // No extension is supported.
    if (find_attribute(node, "requiredExtensions") != nullptr) return false;
    const std::string_view* features = find_attribute(node, "requiredFeatures");
    if (features != nullptr && !std::ranges::all_of(words_of(trimmed(*features), ' '), is_feature_of_pictures)) return false;
    const std::string_view* languages = find_attribute(node, "systemLanguage");
    return languages == nullptr || std::ranges::any_of(words_of(*languages, ','), is_english);
}

void draw_use(SvgReader& reader, SvgContext& context) {
    const std::string_view reference = href_of(*context.node);
    context.map =
        context.map * translation(length_of(context, "x", LengthAxis::x, 0), length_of(context, "y", LengthAxis::y, 0));
    const SvgNode* target = find_reference(reader, reference);
    if (target == nullptr) {
        const bool elsewhere = !reference.empty() && !reference.starts_with('#');
        reader.warnings.add(elsewhere ? "{} use elements refer to other files and are left out"
                                      : "{} use elements refer to nothing and are left out",
                            *context.node);
        return;
    }
    if (reader.open.contains(target)) {
        reader.warnings.add("{} references that lead back to themselves are skipped", *context.node);
        return;
    }
    if (is_svg(*target) && (target->name == "symbol" || target->name == "svg"))
        return draw_used_viewport(reader, context, *target);
    draw_node(reader, context, *target);
}

void draw_nested_svg(SvgReader& reader, const SvgContext& context) {
    const double x = length_of(context, "x", LengthAxis::x, 0), y = length_of(context, "y", LengthAxis::y, 0);
    const double width = length_of(context, "width", LengthAxis::x, context.units.width);
    const double height = length_of(context, "height", LengthAxis::y, context.units.height);
    // Effects of the element itself count in the space around its viewport.
    SvgContext inside = context;
    inside.map = context.map * translation(x, y);
    draw_in_viewport(reader, inside, width, height);
}

void draw_switch(SvgReader& reader, const SvgContext& context) {
    for (const SvgNode* child = context.node->first_child; child != nullptr; child = child->next) {
        if (is_text(*child) || !passes_conditions(*child)) continue;
        draw_node(reader, context, *child);
        return;
    }
}

}  // namespace rinceau
