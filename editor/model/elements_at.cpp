#include "editor/model/elements_at.h"

#include "editor/model/picture_boxes.h"

namespace rinceau {

std::vector<int> elements_at(const DerivedPicture& picture, Point at, double reach, std::size_t most) {
    const PictureBoxes boxes(picture);
    std::vector<int> found;
    for (auto item = picture.items.rbegin(); item != picture.items.rend() && found.size() < most; ++item) {
        const Box& box = boxes.own_box(item->order);
        if (is_empty(box)) continue;
        const Point own = apply(inverse(item->pose), at);
        if (contains(grown(box, reach / scale_of(item->pose)), Box{own, own})) found.push_back(item->order);
    }
    return found;
}

}  // namespace rinceau
