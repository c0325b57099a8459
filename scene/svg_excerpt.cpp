#include "scene/svg_excerpt.h"

#include <algorithm>
#include <cmath>

#include "scene/compound_path.h"
#include "scene/svg_draw.h"
#include "scene/svg_number.h"
#include "scene/svg_verbatim.h"

namespace rinceau {
namespace {

/// From the user space of an element to px of the outermost viewport.
Affine map_inside(SvgReader& reader, const SvgContext& root, const SvgNode& element) {
    if (&element == root.node) return root.map;
    std::vector<const SvgNode*> way;
    for (const SvgNode* up = &element; up != root.node; up = up->parent) way.push_back(up);
    SvgContext context = root;
    for (auto node = way.rbegin(); node != way.rend(); ++node) {
        const SvgContext parent = context;
        context = enter(reader, parent, **node);
    }
    return context.map;
}

Box image_of(const Box& box, const Affine& map) {
    Box image;
    for (const Point corner : {box.low, box.high, Point{box.low.x, box.high.y}, Point{box.high.x, box.low.y}})
        image = including(image, apply(map, corner));
    return image;
}

class ExcerptDrawer {
  public:
    ExcerptDrawer(SvgReader& reader, const SvgSelection& selection)
        : reader_(reader), chosen_(selection.chosen.begin(), selection.chosen.end()), left_(chosen_.size()) {
        for (const SvgNode* node : selection.chosen)
            for (const SvgNode* up = node->parent; up != nullptr; up = up->parent) above_chosen_.insert(up);
        for (const SvgNode* up = selection.parent; up != nullptr; up = up->parent) around_place_.insert(up);
    }

    /// The chosen elements, and on the way those between them.
    void draw_children_of(const SvgContext& context) {
        for (const SvgNode* child = context.node->first_child; child != nullptr; child = child->next)
            if (!is_text(*child) && left_ > 0) draw(context, *child);
    }

    std::size_t overtaken() const { return overtaken_; }

  private:
    void draw(const SvgContext& parent, const SvgNode& node) {
        if (chosen_.contains(&node)) {
            --left_;
            draw_node(reader_, parent, node);
        } else if (above_chosen_.contains(&node)) {
            const SvgContext context = enter(reader_, parent, node);
            const std::size_t first = reader_.scene.elements.size();
            draw_children_of(context);
            if (!around_place_.contains(&node)) fade(first, context);
        } else if (!reader_.scene.elements.empty()) {
            count_overtaken(parent, node);
        }
    }

    void fade(std::size_t first, const SvgContext& context) {
        if (context.style.opacity == 1) return;
        for (std::size_t i = first; i < reader_.scene.elements.size(); ++i) {
            Element& element = reader_.scene.elements[i];
            element.style.opacity *= context.style.opacity;
            if (element.verbatim.empty()) continue;
            element = wrapped(reader_, element, "opacity=\"" + svg_number(context.style.opacity) + "\"", {},
                              element.verbatim_box, *context.node);
        }
    }

    /// Where an element draws; a kept one that does not know may draw anywhere.
    static Box box_of(const Element& element) {
        const double everywhere = std::numeric_limits<double>::max();
        const Box box = painted_box(element);
        return is_empty(box) && !element.verbatim.empty() ? Box{{-everywhere, -everywhere}, {everywhere, everywhere}} : box;
    }

    void count_overtaken(const SvgContext& parent, const SvgNode& node) {
        const SvgWarningLog::Mark warnings = reader_.warnings.mark();
        const std::size_t first = reader_.scene.elements.size();
        draw_node(reader_, parent, node);
        for (; boxes_.size() < first; boxes_.push_back(box_of(reader_.scene.elements[boxes_.size()]))) {
        }
        for (std::size_t i = first; i < reader_.scene.elements.size(); ++i) {
            const Box box = box_of(reader_.scene.elements[i]);
            if (std::ranges::any_of(boxes_, [&](const Box& lower) { return overlap(lower, box); })) ++overtaken_;
        }
        take_back(reader_, first, warnings);
    }

    SvgReader& reader_;
    std::unordered_set<const SvgNode*> chosen_, above_chosen_, around_place_;
    std::size_t left_;
    std::size_t overtaken_ = 0;
    std::vector<Box> boxes_;  ///< of the chosen elements that have been drawn
};

}  // namespace

SvgExcerpt read_excerpt(SvgReader& reader, const SvgContext& root, const SvgSelection& selection) {
    const Affine inside = map_inside(reader, root, *selection.parent);
    if (determinant(inside) == 0)
        throw InputError(place_of(reader, *selection.parent), "the group around the selection is flattened by its transform");

    // What is inside the place is measured in its own units.
    const Affine to_place = inverse(inside);
    const Box page = image_of(reader.scene.viewport, scene_from_svg);
    reader.scene.viewport = image_of(image_of(page, to_place), scene_from_svg);
    reader.tolerance = invisible_share * diagonal(reader.scene.viewport);
    reader.pixel = std::sqrt(std::abs(determinant(to_place)));
    SvgContext context = root;
    context.map = to_place * root.map;

    const SvgOpening opening(reader, *root.node);
    ExcerptDrawer drawer(reader, selection);
    drawer.draw_children_of(context);
    if (reader.options.split_compound_paths) reader.scene.elements = split_compound_paths(std::move(reader.scene.elements));
    return {std::move(reader.scene), reader.warnings.summary(reader.options.file_name), drawer.overtaken()};
}

}  // namespace rinceau
