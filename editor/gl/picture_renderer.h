#pragma once
// Draws a derived picture with OpenGL 3.3, as a browser draws its SVG: one mesh per terminal and style, instanced.

#include <memory>
#include <string>

#include "editor/gl/picture_emphasis.h"
#include "editor/model/derived_picture.h"
#include "editor/model/view_transform.h"

namespace rinceau {

/// Around and over the picture.
struct PictureSurround {
    Color ground{224, 224, 224};  ///< outside the canvas of the picture
    Color accent{230, 90, 0};     ///< of outlines and differences
    double outside_fade = 0.6;    ///< 0..1: how far what lies outside the canvas fades into the ground
    friend constexpr bool operator==(const PictureSurround&, const PictureSurround&) = default;
};

struct PictureDrawOptions {
    PictureSurround surround;
    bool finish = false;  ///< as fine as it gets, at once: for pictures that are written to a file
};

/// Draws into a texture of its own, so that a frame in which nothing has changed costs nothing. Needs a current context for
/// its whole life; leaves the default framebuffer bound, without blending, depth and scissor tests.
class PictureRenderer {
  public:
    /// Throws std::runtime_error, naming the reason, if the context lacks OpenGL 3.3.
    PictureRenderer();
    ~PictureRenderer();
    PictureRenderer(const PictureRenderer&) = delete;
    PictureRenderer& operator=(const PictureRenderer&) = delete;

    /// The picture, over white within its canvas and over the ground outside, as a texture of view.size pixels (at least
    /// 1 x 1), lowest row first as OpenGL has it; the name of the texture. Null draws the ground alone. Returns after about
    /// 30 ms at the latest unless one drawing of the whole takes longer or options.finish is set. The same arguments with
    /// options.finish give the same bytes.
    unsigned draw(const std::shared_ptr<const DerivedPicture>& picture, const ViewTransform& view,
                  const PictureEmphasis& emphasis = {}, const PictureDrawOptions& options = {});

    /// Would drawing again make the picture finer? (It is refined while nothing changes.)
    bool refining() const;

    /// What of the picture that was drawn last could not be shown, as a sentence; empty = everything is shown.
    const std::string& shortcoming() const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace rinceau
