#include "scene/svg_mask.h"

#include <algorithm>
#include <iterator>

#include "scene/svg_attribute_check.h"
#include "scene/svg_clip.h"
#include "scene/svg_draw.h"
#include "scene/svg_number.h"

namespace rinceau {
namespace {

// A mask with more elements is a picture of its own; looking at it anew for each use would cost too much.
constexpr int most_elements = 50;

int elements_below(const SvgNode& node) {
    int count = 0;
    for (const SvgNode* child = node.first_child; child != nullptr && count <= most_elements; child = child->next)
        if (!is_text(*child)) count += 1 + elements_below(*child);
    return count;
}

bool masks_by_alpha(const SvgContext& mask) {
    const std::string* value = find_value(mask.specified, "mask-type");
    return value != nullptr && *value == "alpha";
}

bool is_plain(const Element& element, bool by_alpha) {
    const Style& style = element.style;
    const Color* color = std::get_if<Color>(&style.fill);
    return element.verbatim.empty() && color != nullptr && style.opacity >= 1 && style.fill_opacity >= 1 &&
           !paints_stroke(style) && (by_alpha || *color == Color{255, 255, 255});
}

bool is_in_box_units(const SvgNode& node, std::string_view attribute, bool otherwise) {
    const std::string_view* units = find_attribute(node, attribute);
    return units == nullptr ? otherwise
                            : trimmed(*units) == "objectBoundingBox" || (otherwise && trimmed(*units) != "userSpaceOnUse");
}

/// From units of the box to user space; nothing if the box cannot be told or has no area.
std::optional<Affine> box_map(SvgReader& reader, const SvgContext& masked, std::size_t first) {
    const auto box = object_box(reader, masked, first);
    if (!box || !(width(*box) > 0) || !(height(*box) > 0)) return std::nullopt;
    return Affine{width(*box), 0, 0, height(*box), box->low.x, box->low.y};
}

/// The part of the mask outside of which nothing is seen, in the masked element's user space.
std::optional<std::vector<Point>> region_of(SvgReader& reader, const SvgContext& masked, const SvgNode& node,
                                            std::size_t first) {
    const bool boxed = is_in_box_units(node, "maskUnits", true);
    const auto map = boxed ? box_map(reader, masked, first) : Affine{};
    if (!map) return std::nullopt;
    const UnitContext units = boxed ? UnitContext{.width = 1, .height = 1} : masked.units;
    const auto value = [&](std::string_view name, LengthAxis axis, std::string_view otherwise) {
        const std::string_view* text = find_attribute(node, name);
        const auto length = text == nullptr ? std::nullopt : parse_length(*text, units, axis);
        return length ? *length : *parse_length(otherwise, units, axis);
    };
    const double x = value("x", LengthAxis::x, "-10%"), y = value("y", LengthAxis::y, "-10%");
    const double right = x + value("width", LengthAxis::x, "120%"), bottom = y + value("height", LengthAxis::y, "120%");
    if (!(right > x) || !(bottom > y)) return std::nullopt;
    return std::vector<Point>{apply(*map, {x, y}), apply(*map, {right, y}), apply(*map, {right, bottom}),
                              apply(*map, {x, bottom})};
}

/// The mask's shapes in scene space, if all of them are plain.
std::optional<std::vector<SvgClipShape>> plain_shapes(SvgReader& reader, const SvgContext& masked, const SvgNode& node,
                                                      std::size_t first) {
    const bool boxed = is_in_box_units(node, "maskContentUnits", false);
    const auto map = boxed ? box_map(reader, masked, first) : Affine{};
    if (!map) return std::nullopt;
    const auto above = ancestor_contexts(reader, node);
    above.back()->map = masked.map * *map;
    above.back()->units = boxed ? UnitContext{.width = 1, .height = 1} : masked.units;
    above.back()->depth = masked.depth;
    const SvgContext context = enter(reader, *above.back(), node);
    if (!context.style.clip_path.empty() || !context.style.mask.empty() || !context.style.filter.empty())
        return std::nullopt;
    check_attributes(reader, node, context.specified);
    std::vector<Element>& elements = reader.scene.elements;
    const std::size_t before = elements.size(), blended = reader.blended;
    draw_children(reader, context);
    std::vector<SvgClipShape> shapes;
    bool plain = reader.blended == blended;
    for (std::size_t i = before; i < elements.size(); ++i) {
        plain = plain && is_plain(elements[i], masks_by_alpha(context));
        shapes.push_back({std::move(elements[i].paths), elements[i].style.fill_rule});
    }
    elements.resize(before);
    reader.blended = blended;
    return plain ? std::optional(std::move(shapes)) : std::nullopt;
}

}  // namespace

MaskResult apply_mask(SvgReader& reader, const SvgContext& context, std::size_t first) {
    const auto url = parse_url(context.style.mask);
    if (!url) return MaskResult::unknown;
    const SvgNode* node = find_reference(reader, *url);
    if (node == nullptr || !is_svg(*node) || node->name != "mask") return MaskResult::absent;
    const SvgOpening opening(reader, *node);
    if (!opening.fresh || elements_below(*node) > most_elements) return MaskResult::unknown;
    const SvgWarningLog::Mark mark = reader.warnings.mark();
    const auto region = region_of(reader, context, *node, first);
    const auto shapes = region ? plain_shapes(reader, context, *node, first) : std::nullopt;
    if (!shapes) {
        reader.warnings.take_back(mark);
        return MaskResult::unknown;
    }
    clip_to_polygon(reader, first, context.map, *region, *node);
    clip_to_shapes(reader, first, *shapes, *node);
    return MaskResult::applied;
}

}  // namespace rinceau
