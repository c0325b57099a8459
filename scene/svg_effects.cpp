#include "scene/svg_effects.h"

#include <algorithm>

#include "scene/painted_region.h"
#include "scene/svg_clip.h"
#include "scene/svg_mask.h"
#include "scene/svg_number.h"
#include "scene/svg_verbatim.h"

namespace rinceau {
namespace {

// Pairs of elements whose boxes meet that are looked at more closely; with more, a group counts as overlapping.
constexpr int most_close_looks = 2000;

bool inks_overlap(const Element& a, const Element& b, double tolerance) {
    if (!a.verbatim.empty() || !b.verbatim.empty()) return true;
    const Region common = intersection_of(painted_region(a, 0.25 * tolerance), painted_region(b, 0.25 * tolerance));
    return !common.empty() && area(common) > tolerance * diagonal(bounds(common));
}

/// May any two of the elements from `first` on paint the same place?
bool any_overlap(const std::vector<Element>& elements, std::size_t first, double tolerance) {
    struct Extent {
        Box box;
        std::size_t element = 0;
    };
    std::vector<Extent> extents;
    for (std::size_t i = first; i < elements.size(); ++i) {
        extents.push_back({painted_box(elements[i]), i});
        if (is_empty(extents.back().box)) return true;
    }
    std::ranges::sort(extents, [](const Extent& a, const Extent& b) { return a.box.low.x < b.box.low.x; });
    int close_looks = 0;
    for (std::size_t i = 0; i < extents.size(); ++i)
        for (std::size_t j = i + 1; j < extents.size() && extents[j].box.low.x <= extents[i].box.high.x; ++j) {
            if (!overlap(extents[i].box, extents[j].box)) continue;
            if (++close_looks > most_close_looks) return true;
            if (inks_overlap(elements[extents[i].element], elements[extents[j].element], tolerance)) return true;
        }
    return false;
}

/// Opacity of fill and stroke together is opacity of the one that is there.
void simplify_opacity(Style& style) {
    if (!paints_stroke(style))
        style.fill_opacity *= std::exchange(style.opacity, 1.0);
    else if (!paints_fill(style))
        style.stroke.opacity *= std::exchange(style.opacity, 1.0);
}

/// False if the opacity holds for several things that overlap.
bool fold_opacity(SvgReader& reader, const SvgContext& context, std::size_t first) {
    std::vector<Element>& elements = reader.scene.elements;
    if (elements.size() - first > 1 && any_overlap(elements, first, reader.tolerance)) return false;
    const double opacity = context.style.opacity;
    for (std::size_t i = first; i < elements.size(); ++i) {
        Element& element = elements[i];
        if (element.verbatim.empty()) {
            element.style.opacity *= opacity;
            simplify_opacity(element.style);
        } else {
            const std::string attribute = "opacity=\"" + svg_number(opacity) + "\"";
            element = wrapped(reader, element, attribute, {}, element.verbatim_box, *context.node);
        }
    }
    return true;
}

Box common_box(const SvgReader& reader, std::size_t first) {
    Box box;
    for (std::size_t i = first; i < reader.scene.elements.size(); ++i) {
        const Box part = painted_box(reader.scene.elements[i]);
        if (is_empty(part)) return {};
        box = including(box, part);
    }
    return box;
}

void keep_whole(SvgReader& reader, const SvgContext& context, const SvgMark& mark, std::string_view warning) {
    const bool may_spread = !context.style.filter.empty();
    const Box box = may_spread ? Box{} : common_box(reader, mark.elements);
    take_back(reader, mark.elements, mark.warnings);
    keep_verbatim(reader, context, box, warning);
}

/// A reference to nothing does not filter.
bool has_filter(SvgReader& reader, const SvgContext& context) {
    const auto url = parse_url(context.style.filter);
    // Functions of CSS, and lists of filters.
    if (!url || context.style.filter.find(')') + 1 < context.style.filter.size()) return !context.style.filter.empty();
    const SvgNode* node = find_reference(reader, *url);
    const bool exists = node != nullptr && is_svg(*node) && node->name == "filter";
    if (!exists) reader.warnings.add("{} filters do not exist and do nothing", *context.node);
    return exists;
}

/// False if the mask is not plain.
bool mask_elements(SvgReader& reader, const SvgContext& context, std::size_t first) {
    if (context.style.mask.empty()) return true;
    const MaskResult result = apply_mask(reader, context, first);
    if (result == MaskResult::absent) reader.warnings.add("{} masks do not exist and do nothing", *context.node);
    return result != MaskResult::unknown;
}

}  // namespace

SvgMark mark_of(const SvgReader& reader) { return {reader.scene.elements.size(), reader.warnings.mark(), reader.blended}; }

void finish_effects(SvgReader& reader, const SvgContext& context, const SvgMark& mark) {
    const SvgStyle& style = context.style;
    const bool empty = reader.scene.elements.size() == mark.elements;
    // A filter can draw where nothing was.
    if (empty && style.filter.empty()) return;
    if (style.opacity <= 0) {
        take_back(reader, mark.elements, mark.warnings);
        reader.warnings.add("{} elements of opacity 0 are left out", *context.node);
        return;
    }
    if (has_filter(reader, context)) return keep_whole(reader, context, mark, "{} filtered elements are kept as they are");
    if (style.blended) {
        ++reader.blended;
        return keep_whole(reader, context, mark, "{} blended elements (mix-blend-mode) are kept as they are");
    }
    const bool isolates = style.isolated || style.opacity < 1 || !style.clip_path.empty() || !style.mask.empty();
    if (isolates && reader.blended > mark.blended) {
        // What is below the group does not shine through: outside it blends no more.
        reader.blended = mark.blended;
        return keep_whole(reader, context, mark, "{} groups with blended elements are kept as they are");
    }
    if (!style.clip_path.empty() && !apply_clip_path(reader, context, mark.elements))
        return keep_whole(reader, context, mark,
                          "{} elements with a clip that is not made of plain shapes are kept as they are");
    if (!mask_elements(reader, context, mark.elements))
        return keep_whole(reader, context, mark, "{} masked elements are kept as they are");
    if (style.opacity < 1 && !fold_opacity(reader, context, mark.elements))
        keep_whole(reader, context, mark, "{} groups of overlapping elements with a common opacity are kept as they are");
}

}  // namespace rinceau
