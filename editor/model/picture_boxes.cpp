#include "editor/model/picture_boxes.h"

namespace rinceau {
namespace {

const Box empty_box;

}  // namespace

PictureBoxes::PictureBoxes(const DerivedPicture& picture) : picture_(picture), by_order_(picture.items.size(), -1) {
    for (const PictureLook& look : picture.looks) {
        const Terminal& terminal = picture.grammar->terminals[static_cast<std::size_t>(look.terminal)];
        by_look_.push_back(terminal.verbatim.empty() ? bounds(terminal.paths) : terminal.verbatim_box);
    }
    for (std::size_t i = 0; i < picture.items.size(); ++i) {
        const auto order = static_cast<std::size_t>(picture.items[i].order);
        if (order < by_order_.size()) by_order_[order] = static_cast<std::int32_t>(i);
    }
}

const PictureItem* PictureBoxes::item(int order) const {
    const bool known = order >= 0 && static_cast<std::size_t>(order) < by_order_.size();
    const std::int32_t index = known ? by_order_[static_cast<std::size_t>(order)] : -1;
    return index < 0 ? nullptr : &picture_.items[static_cast<std::size_t>(index)];
}

const Box& PictureBoxes::own_box(int order) const {
    const PictureItem* found = item(order);
    return found == nullptr ? empty_box : by_look_[static_cast<std::size_t>(found->look)];
}

std::array<Point, 4> PictureBoxes::corners(int order) const {
    const Box& box = own_box(order);
    const Similarity& pose = item(order)->pose;
    return {apply(pose, box.low), apply(pose, {box.high.x, box.low.y}), apply(pose, box.high),
            apply(pose, {box.low.x, box.high.y})};
}

Box PictureBoxes::box(int first, int last) const {
    Box all;
    for (int order = first; order < last; ++order) {
        if (is_empty(own_box(order))) continue;
        for (const Point corner : corners(order)) all = including(all, corner);
    }
    return all;
}

}  // namespace rinceau
