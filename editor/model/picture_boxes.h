#pragma once
// Boxes of what a picture shows, by order of derivation.

#include <array>
#include <vector>

#include "editor/model/derived_picture.h"
#include "geometry/box.h"

namespace rinceau {

/// Boxes of a picture's elements. Refers to the picture.
class PictureBoxes {
  public:
    explicit PictureBoxes(const DerivedPicture& picture);

    /// Of the element of that order in its own frame: of its outlines; of what it may paint, if it is verbatim. Empty if
    /// there is none.
    const Box& own_box(int order) const;
    const PictureItem* item(int order) const;

    /// The corners of the own box in the scene, around it. The own box must not be empty.
    std::array<Point, 4> corners(int order) const;

    /// Of the elements [first, last), in the scene.
    Box box(int first, int last) const;

  private:
    const DerivedPicture& picture_;
    std::vector<Box> by_look_;
    std::vector<std::int32_t> by_order_;  ///< -1 = none
};

}  // namespace rinceau
