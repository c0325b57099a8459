#pragma once
// Small pictures of single looks, for lists.

#include <memory>
#include <optional>

#include "editor/model/derived_picture.h"

namespace rinceau {

/// Needs a current context for its whole life; leaves the default framebuffer bound.
class ThumbnailRenderer {
  public:
    ThumbnailRenderer();
    ~ThumbnailRenderer();
    ThumbnailRenderer(const ThumbnailRenderer&) = delete;
    ThumbnailRenderer& operator=(const ThumbnailRenderer&) = delete;

    /// To be called once a frame: thumbnails get so much time in it.
    void begin_frame();

    /// The look, turned as its first item in the picture, fitted into a square of so many pixels (> 0), over white, or over
    /// grey if it is nearly white itself: the name of a texture, lowest row first. Looks with the same content share it.
    /// Nothing if the time of this frame is over: ask again in the next one.
    std::optional<unsigned> thumbnail(const std::shared_ptr<const DerivedPicture>& picture, int look, int pixels);

    /// Has one been refused in this frame?
    bool waiting() const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace rinceau
