#pragma once
// A frame that is drawn into memory instead of a window.

#include "scene/picture.h"

namespace rinceau {

/// Needs a current context for its whole life.
class OffscreenFrame {
  public:
    OffscreenFrame(int width, int height);
    ~OffscreenFrame();
    OffscreenFrame(const OffscreenFrame&) = delete;
    OffscreenFrame& operator=(const OffscreenFrame&) = delete;

    /// What is drawn from now on goes here.
    void bind() const;
    /// What was drawn.
    Picture read() const;

  private:
    int width_;
    int height_;
    unsigned framebuffer_ = 0;
    unsigned pixels_ = 0;
};

/// What a texture of that size shows. Needs a current context.
Picture picture_of_texture(unsigned texture, int width, int height);

}  // namespace rinceau
