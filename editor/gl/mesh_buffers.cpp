#include "editor/gl/mesh_buffers.h"

#include <cstddef>

#include "editor/gl/picture_shaders.h"

namespace rinceau {
namespace {

constexpr std::uint64_t frames_kept = 120;
constexpr std::size_t many_meshes = 256;

void upload(MeshBuffer& buffer) {
    const ShapeMesh& mesh = *buffer.mesh;
    glBindVertexArray(buffer.array.name());
    glBindBuffer(GL_ARRAY_BUFFER, buffer.vertices.name());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.vertices.size() * sizeof(ShapeVertex)), mesh.vertices.data(),
                 GL_STATIC_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer.indices.name());
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.indices.size() * sizeof(std::uint32_t)),
                 mesh.indices.data(), GL_STATIC_DRAW);
    glEnableVertexAttribArray(attribute_slot::point);
    glVertexAttribPointer(attribute_slot::point, 2, GL_FLOAT, GL_FALSE, sizeof(ShapeVertex), nullptr);
    glEnableVertexAttribArray(attribute_slot::part);
    glVertexAttribPointer(attribute_slot::part, 1, GL_FLOAT, GL_FALSE, sizeof(ShapeVertex),
                          reinterpret_cast<const void*>(offsetof(ShapeVertex, part)));
    for (const unsigned slot : {attribute_slot::pose, attribute_slot::place, attribute_slot::fill, attribute_slot::stroke}) {
        glEnableVertexAttribArray(slot);
        glVertexAttribDivisor(slot, 1);
    }
}

}  // namespace

const MeshBuffer& MeshBuffers::of(const std::shared_ptr<const ShapeMesh>& mesh) {
    MeshBuffer& buffer = buffers_[mesh.get()];
    if (!buffer.mesh) {
        buffer.mesh = mesh;
        upload(buffer);
    }
    buffer.last_use = now_;
    return buffer;
}

void MeshBuffers::forget_unused() {
    ++now_;
    if (buffers_.size() < many_meshes) return;
    std::erase_if(buffers_, [&](const auto& entry) { return entry.second.last_use + frames_kept < now_; });
}

}  // namespace rinceau
