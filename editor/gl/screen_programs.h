#pragma once
// Programs that go over all pixels: averages of passes, and what a frame is put together from.

#include "editor/gl/gl_handle.h"
#include "editor/gl/pixel_target.h"
#include "editor/gl/shader.h"
#include "editor/model/view_transform.h"
#include "geometry/box.h"
#include "scene/style.h"

namespace rinceau {

/// A texture whose texels times `weight` are a layer's colours; name 0 = nothing.
struct WeightedTexture {
    GLuint name = 0;
    float weight = 1;
};

/// What a frame is put together from.
struct FrameParts {
    WeightedTexture picture;
    WeightedTexture lit;     ///< what does not fade
    bool fades = false;      ///< what is not lit fades
    WeightedTexture before;  ///< what the picture is compared with
    bool difference = false;
    WeightedTexture mask;  ///< what gets a line around
    Box canvas;            ///< pixels from the lower left corner; empty = all is canvas
    Color ground, accent;
    float outside_fade = 0;
};

class ScreenPrograms {
  public:
    ScreenPrograms();
    /// Adds a texture of the same size to the target, or puts it there.
    void add(const PixelTarget& target, GLuint texture, bool replace) const;
    void compose(const PixelTarget& target, const FrameParts& parts) const;

  private:
    GlVertexArray no_vertices_;
    GlProgram copy_, compose_plain_, compose_compared_;
};

}  // namespace rinceau
