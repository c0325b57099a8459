#pragma once
// Textures that are drawn into.

#include "editor/gl/gl_handle.h"

namespace rinceau {

/// Internal format of the texture's texels.
enum class PixelFormat : unsigned char { bytes, halves };

/// A colour texture, with a depth buffer if asked for. Reading outside gives the nearest texel.
class PixelTarget {
  public:
    PixelTarget(PixelFormat format, bool with_depth) : format_(format), with_depth_(with_depth) {}

    /// Has no content afterwards if the size has changed. At least 1 x 1.
    void resize(int width, int height);
    /// Binds the framebuffer and sets the viewport.
    void bind() const;
    GLuint texture() const { return color_.name(); }
    int width() const { return width_; }
    int height() const { return height_; }

  private:
    PixelFormat format_;
    bool with_depth_;
    int width_ = 0, height_ = 0;
    GlTexture color_, depth_;
    GlFramebuffer framebuffer_;
};

}  // namespace rinceau
