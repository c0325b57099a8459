#include "scene/svg_clip.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "scene/compound_path.h"
#include "scene/painted_region.h"
#include "scene/svg_attribute_check.h"
#include "scene/svg_number.h"
#include "scene/svg_outline.h"
#include "scene/svg_verbatim.h"
#include "scene/svg_write.h"

namespace rinceau {

/// A clip in scene space: what lies in any of the shapes and, if there is one, in `within`.
struct SvgClip {
    std::vector<SvgClipShape> shapes;
    std::shared_ptr<const SvgClip> within;
    Region grown, shrunk;  ///< by the tolerance
    Box inner_box;         ///< if the region is an axis-parallel rectangle: that rectangle grown by the tolerance
    Box outer_box;
};

namespace {

bool is_rectangle(const Region& region, const Box& box, double tolerance) {
    return region.size() == 1 && std::abs(area(region) - width(box) * height(box)) <= tolerance * (width(box) + height(box));
}

void settle(SvgClip& clip, double tolerance) {
    Region region;
    for (const SvgClipShape& shape : clip.shapes) {
        Region part = enclosed_region(shape.paths, shape.rule, 0.25 * tolerance);
        region = region.empty() ? std::move(part) : union_of(region, part);
    }
    clip.grown = offset_region(region, tolerance);
    clip.shrunk = offset_region(region, -tolerance);
    clip.outer_box = bounds(clip.shrunk);
    if (is_rectangle(region, bounds(region), tolerance)) clip.inner_box = bounds(clip.grown);
}

/// What one child of a clipPath adds, or nothing if it is of a sort that cannot be told.
class ClipReader {
  public:
    explicit ClipReader(SvgReader& reader) : reader_(reader) {}

    /// False if the clip cannot be told.
    bool read_children(const SvgContext& context, SvgClip& clip) {
        for (const SvgNode* child = context.node->first_child; child != nullptr; child = child->next) {
            if (is_text(*child) || !is_svg(*child)) continue;
            if (!is_shape(child->name) && child->name != "use" && child->name != "text") continue;
            if (!read_child(enter(reader_, context, *child), clip)) return false;
        }
        return true;
    }

  private:
    bool read_child(SvgContext context, SvgClip& clip) {
        if (!context.style.displayed) return true;
        check_attributes(reader_, *context.node, context.specified);
        if (!context.style.clip_path.empty()) return false;
        if (context.node->name == "use") return read_use(context, clip);
        if (!is_shape(context.node->name)) return false;
        if (!context.style.visible) return true;
        std::vector<Path> paths = transformed(outline_of(reader_, context), scene_map(context));
        if (!is_in_range(paths)) return false;
        if (!paths.empty()) clip.shapes.push_back({std::move(paths), context.style.clip_rule});
        return true;
    }

    bool read_use(SvgContext& context, SvgClip& clip) {
        const SvgNode* target = find_reference(reader_, href_of(*context.node));
        if (target == nullptr) return true;
        // Only shapes may be used here.
        if (!is_svg(*target) || !is_shape(target->name)) return target->name != "text";
        context.map =
            context.map *
            Affine{1, 0, 0, 1, length_of(context, "x", LengthAxis::x, 0), length_of(context, "y", LengthAxis::y, 0)};
        return read_child(enter(reader_, context, *target), clip);
    }

    SvgReader& reader_;
};

const SvgNode* clip_node(const SvgReader& reader, std::string_view value) {
    const auto url = parse_url(value);
    const SvgNode* node = url ? find_reference(reader, *url) : nullptr;
    return node != nullptr && is_svg(*node) && node->name == "clipPath" ? node : nullptr;
}

bool is_in_box_units(const SvgNode& node) {
    const std::string_view* units = find_attribute(node, "clipPathUnits");
    return units != nullptr && trimmed(*units) == "objectBoundingBox";
}

/// `user` is from the clipped element's user space to SVG px. Null if the clip cannot be told.
std::shared_ptr<const SvgClip> read_clip(SvgReader& reader, const SvgContext& clipped, std::size_t first,
                                         const SvgNode& node) {
    const SvgOpening opening(reader, node);
    if (!opening.fresh) return nullptr;
    Affine map = clipped.map;
    const bool boxed = is_in_box_units(node);
    if (boxed) {
        const auto box = object_box(reader, clipped, first);
        if (!box || !(width(*box) > 0) || !(height(*box) > 0)) return nullptr;
        map = map * Affine{width(*box), 0, 0, height(*box), box->low.x, box->low.y};
    }
    auto& cached = reader.clips[&node];
    if (cached.clip && cached.map == map) return cached.clip;
    const auto above = ancestor_contexts(reader, node);
    above.back()->map = map;
    above.back()->units = boxed ? UnitContext{.width = 1, .height = 1} : clipped.units;
    const SvgContext context = enter(reader, *above.back(), node);
    check_attributes(reader, node, context.specified);
    auto clip = std::make_shared<SvgClip>();
    if (!ClipReader(reader).read_children(context, *clip)) return nullptr;
    settle(*clip, reader.tolerance);
    if (!context.style.clip_path.empty()) {
        const SvgNode* outer = clip_node(reader, context.style.clip_path);
        if (outer == nullptr || is_in_box_units(*outer)) return nullptr;
        SvgContext same_space = clipped;
        same_space.map = context.map;
        clip->within = read_clip(reader, same_space, first, *outer);
        if (!clip->within) return nullptr;
    }
    reader.clips[&node] = {map, clip};
    return clip;
}

/// In rising order of effect: of two clips the stronger one counts.
enum class ClipEffect { none, part, all };

bool negligible(const Region& region, double tolerance) {
    return region.empty() || area(region) <= tolerance * diagonal(bounds(region));
}

ClipEffect effect_on(const Element& element, const SvgClip& clip, double tolerance) {
    const Box box = painted_box(element);
    if (is_empty(clip.outer_box)) return ClipEffect::all;
    if (is_empty(box)) return ClipEffect::part;
    if (!is_empty(clip.inner_box) && contains(clip.inner_box, box)) return ClipEffect::none;
    if (!overlap(clip.outer_box, box)) return ClipEffect::all;
    Region ink = {{box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}}};
    if (element.verbatim.empty()) ink = painted_region(element, 0.25 * tolerance);
    if (negligible(difference_of(ink, clip.grown), tolerance)) return ClipEffect::none;
    return negligible(intersection_of(ink, clip.shrunk), tolerance) ? ClipEffect::all : ClipEffect::part;
}

std::string clip_definition(const SvgClip& clip, const std::string& prefix, int number) {
    std::string text;
    if (clip.within) text = clip_definition(*clip.within, prefix, number + 1);
    text += "<clipPath id=\"" + prefix + "c" + std::to_string(number) + "\"";
    if (clip.within) text += " clip-path=\"url(#" + prefix + "c" + std::to_string(number + 1) + ")\"";
    text += ">";
    for (const SvgClipShape& shape : clip.shapes) {
        text += "<path d=\"" + svg_path_data(shape.paths) + "\"";
        if (shape.rule == FillRule::evenodd) text += " clip-rule=\"evenodd\"";
        text += "/>";
    }
    return text + "</clipPath>";
}

Box common_box(const Box& a, const Box& b) {
    if (is_empty(a)) return b;
    return {{std::max(a.low.x, b.low.x), std::max(a.low.y, b.low.y)},
            {std::min(a.high.x, b.high.x), std::min(a.high.y, b.high.y)}};
}

Element cut(SvgReader& reader, const Element& element, const SvgClip& clip, const SvgNode& owner) {
    const std::string prefix = next_id_prefix(reader);
    const Box box = common_box(painted_box(element), grown(clip.outer_box, 2 * reader.tolerance));
    return wrapped(reader, element, "clip-path=\"url(#" + prefix + "c0)\"", clip_definition(clip, prefix, 0), box, owner);
}

ClipEffect effect_of_all(const Element& element, const SvgClip& clip, double tolerance) {
    ClipEffect effect = ClipEffect::none;
    for (const SvgClip* part = &clip; part != nullptr && effect != ClipEffect::all; part = part->within.get())
        effect = std::max(effect, effect_on(element, *part, tolerance));
    return effect;
}

/// Adds what the clip leaves of an element to `kept`.
void clip_element(SvgReader& reader, Element element, const SvgClip& clip, const SvgNode& owner,
                  std::vector<Element>& kept) {
    switch (effect_of_all(element, clip, reader.tolerance)) {
        case ClipEffect::none:
            kept.push_back(std::move(element));
            return;
        case ClipEffect::all:
            reader.warnings.add("{} elements lie wholly outside their clip and are left out", owner);
            return;
        case ClipEffect::part:
            reader.warnings.add("{} elements cut by a clip are kept as they are", owner);
            kept.push_back(cut(reader, element, clip, owner));
    }
}

void clip_elements(SvgReader& reader, std::size_t first, const SvgClip& clip, const SvgNode& owner) {
    std::vector<Element>& elements = reader.scene.elements;
    std::vector<Element> kept;
    for (std::size_t i = first; i < elements.size(); ++i) {
        // Of a compound path that is cut, most pieces may be whole.
        const bool split = reader.options.split_compound_paths && elements[i].paths.size() > 1 &&
                           effect_of_all(elements[i], clip, reader.tolerance) == ClipEffect::part;
        std::vector<Element> single;
        single.push_back(std::move(elements[i]));
        if (split) single = split_compound_paths(std::move(single));
        for (Element& piece : single) clip_element(reader, std::move(piece), clip, owner, kept);
    }
    elements.resize(first);
    std::ranges::move(kept, std::back_inserter(elements));
}

/// Do the boxes of all elements from `first` on lie in the convex polygon? Saves looking closely at most of them.
bool all_inside(const std::vector<Element>& elements, std::size_t first, const std::vector<Point>& polygon,
                double tolerance) {
    const double turn = cross(polygon[1] - polygon[0], polygon[2] - polygon[1]) < 0 ? -1 : 1;
    const auto inside = [&](Point p) {
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Point from = polygon[i], edge = polygon[(i + 1) % polygon.size()] - from;
            if (turn * cross(edge, p - from) < -tolerance * abs(edge)) return false;
        }
        return true;
    };
    for (std::size_t i = first; i < elements.size(); ++i) {
        const Box box = painted_box(elements[i]);
        if (is_empty(box) || !inside(box.low) || !inside(box.high) || !inside({box.low.x, box.high.y}) ||
            !inside({box.high.x, box.low.y}))
            return false;
    }
    return true;
}

}  // namespace

std::optional<Box> object_box(SvgReader& reader, const SvgContext& context, std::size_t first) {
    const SvgWarningLog::Mark mark = reader.warnings.mark();
    if (is_shape(context.node->name)) {
        const Box box = bounds(outline_of(reader, context));
        reader.warnings.take_back(mark);
        return box;
    }
    if (determinant(context.map) == 0) return std::nullopt;
    const Affine back = inverse(scene_map(context));
    Box box;
    for (std::size_t i = first; i < reader.scene.elements.size(); ++i) {
        const Element& element = reader.scene.elements[i];
        if (!element.verbatim.empty()) return std::nullopt;
        box = including(box, bounds(transformed(element.paths, back)));
    }
    return box;
}

bool apply_clip_path(SvgReader& reader, const SvgContext& context, std::size_t first) {
    const SvgNode* node = clip_node(reader, context.style.clip_path);
    if (node == nullptr) {
        // A reference to nothing does not clip; anything but a reference is a shape of CSS.
        const bool reference = parse_url(context.style.clip_path).has_value();
        if (reference)
            reader.warnings.add("{} clips refer to a clipPath that does not exist and do not clip", *context.node);
        return reference;
    }
    const auto clip = read_clip(reader, context, first, *node);
    if (!clip) return false;
    clip_elements(reader, first, *clip, *context.node);
    return true;
}

void clip_to_shapes(SvgReader& reader, std::size_t first, std::vector<SvgClipShape> shapes, const SvgNode& owner) {
    if (reader.scene.elements.size() == first) return;
    SvgClip clip;
    clip.shapes = std::move(shapes);
    settle(clip, reader.tolerance);
    clip_elements(reader, first, clip, owner);
}

void clip_to_polygon(SvgReader& reader, std::size_t first, const Affine& map, const std::vector<Point>& corners,
                     const SvgNode& owner) {
    std::vector<Point> outline;
    for (const Point corner : corners) outline.push_back(apply(scene_from_svg * map, corner));
    if (all_inside(reader.scene.elements, first, outline, reader.tolerance)) return;
    Path path{outline.front(), {}, true};
    for (std::size_t i = 1; i < outline.size(); ++i) path.segments.push_back(line_to(outline[i]));
    clip_to_shapes(reader, first, {{{path}, FillRule::nonzero}}, owner);
}

}  // namespace rinceau
