#pragma once
// Draws a derived picture with OpenGL 3.3: one mesh per terminal and style, instanced.

#include <memory>

#include "editor/model/derived_picture.h"
#include "editor/model/view_transform.h"

namespace rinceau {

/// What is drawn besides the picture's own colours.
struct PictureEmphasis {
    std::shared_ptr<const std::vector<char>> lit;  ///< by PictureItem::order: 0 fades; null = nothing fades
};

/// Draws into a texture of its own, so that a frame in which nothing has changed costs nothing. Needs a current context for
/// its whole life.
class PictureRenderer {
  public:
    PictureRenderer();
    ~PictureRenderer();
    PictureRenderer(const PictureRenderer&) = delete;
    PictureRenderer& operator=(const PictureRenderer&) = delete;

    /// The picture, over white within its canvas and over `ground` outside, as a texture of view.size pixels, upper left
    /// first; the name of the texture. Null draws the ground alone.
    unsigned draw(const std::shared_ptr<const DerivedPicture>& picture, const ViewTransform& view,
                  const PictureEmphasis& emphasis = {});

    /// Would drawing again make the picture finer? (It is refined while nothing changes.)
    bool refining() const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace rinceau
