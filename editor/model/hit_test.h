#pragma once
// What of a picture lies under the mouse.

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "editor/model/derived_picture.h"
#include "geometry/box_tree.h"

namespace rinceau {

/// A picture made ready to be asked many times. Making one takes a few milliseconds for 10,000 items; asking it takes
/// microseconds.
class HitIndex {
  public:
    HitIndex() = default;
    /// Null is an empty picture.
    explicit HitIndex(std::shared_ptr<const DerivedPicture> picture);

    const std::shared_ptr<const DerivedPicture>& picture() const { return picture_; }

    /// PictureItem::order of the topmost item that is hit at a point of the scene: by its fill, by a stroke whose line is
    /// within its half width or within `reach` (scene length), or by a verbatim fragment's box. Where none is, of the
    /// topmost item whose fill is within reach. Dashes are taken as solid. What paints nothing is not hit.
    std::optional<std::int32_t> item_at(Point scene, double reach) const;

    /// PictureItem::order of all items that lie in the box as a whole, rising.
    std::vector<std::int32_t> items_in(const Box& scene) const;

    /// The box of what an item paints, mitres' tips left out; empty if it paints nothing or a fragment of unknown extent.
    /// `item` is an index into DerivedPicture::items.
    Box item_box(std::size_t item) const { return boxes_[item]; }

  private:
    struct Look;
    bool hits(std::size_t item, Point scene, double reach, bool near_fill) const;

    std::shared_ptr<const DerivedPicture> picture_;
    std::shared_ptr<const std::vector<Look>> looks_;
    std::vector<Box> boxes_;
    BoxTree tree_;
};

}  // namespace rinceau
