#pragma once
// Meshes on the graphics card.

#include <cstdint>
#include <memory>
#include <unordered_map>

#include "editor/gl/gl_handle.h"
#include "editor/gl/shape_store.h"

namespace rinceau {

struct MeshBuffer {
    std::shared_ptr<const ShapeMesh> mesh;
    GlVertexArray array;  ///< with point and part of the vertices, and the indices
    GlBuffer vertices, indices;
    std::uint64_t last_use = 0;
};

/// Meshes are uploaded when they are first drawn and let go when they have not been drawn for long, once they are many.
class MeshBuffers {
  public:
    const MeshBuffer& of(const std::shared_ptr<const ShapeMesh>& mesh);
    /// To be called once a frame.
    void forget_unused();

  private:
    std::unordered_map<const ShapeMesh*, MeshBuffer> buffers_;
    std::uint64_t now_ = 0;
};

}  // namespace rinceau
