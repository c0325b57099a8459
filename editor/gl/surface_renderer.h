#pragma once
// Draws a surface, what grows on it and the lines of its field with OpenGL 3.3.

#include <memory>
#include <vector>

#include "editor/model/orbit_view.h"
#include "growth/mesh/triangle_mesh.h"
#include "scene/style.h"

namespace rinceau {

/// What is drawn. Shared parts are uploaded once.
struct SurfacePicture {
    std::shared_ptr<const MeshAssembly> ground;                         ///< null = not drawn
    std::shared_ptr<const MeshAssembly> pattern;                        ///< null = nothing
    std::shared_ptr<const std::vector<std::vector<SpacePoint>>> lines;  ///< over the ground; null = none
    bool wireframe = false;                                             ///< edges of the ground
    Color behind{224, 224, 224};
    Color line{60, 90, 160};
};

/// Draws into a texture of its own; a frame in which nothing has changed costs nothing. Needs a current context for its
/// whole life; leaves the default framebuffer bound, without depth test.
class SurfaceRenderer {
  public:
    SurfaceRenderer();
    ~SurfaceRenderer();
    SurfaceRenderer(const SurfaceRenderer&) = delete;
    SurfaceRenderer& operator=(const SurfaceRenderer&) = delete;

    /// A texture of view.size pixels (at least 1 x 1), lowest row first as OpenGL has it; its name.
    unsigned draw(const SurfacePicture& picture, const OrbitView& view);

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace rinceau
