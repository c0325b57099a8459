#pragma once
// OpenGL objects that are deleted with their owner.

#include <epoxy/gl.h>

#include <utility>

namespace rinceau {

/// Owns one name; `Kind` makes and deletes it. Moved from = 0.
template <class Kind>
class GlHandle {
  public:
    GlHandle() : name_(Kind::make()) {}
    ~GlHandle() {
        if (name_ != 0) Kind::release(name_);
    }
    GlHandle(GlHandle&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    GlHandle& operator=(GlHandle&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }
    GlHandle(const GlHandle&) = delete;
    GlHandle& operator=(const GlHandle&) = delete;

    GLuint name() const { return name_; }

  private:
    GLuint name_ = 0;
};

struct BufferKind {
    static GLuint make() {
        GLuint name = 0;
        glGenBuffers(1, &name);
        return name;
    }
    static void release(GLuint name) { glDeleteBuffers(1, &name); }
};
struct TextureKind {
    static GLuint make() {
        GLuint name = 0;
        glGenTextures(1, &name);
        return name;
    }
    static void release(GLuint name) { glDeleteTextures(1, &name); }
};
struct FramebufferKind {
    static GLuint make() {
        GLuint name = 0;
        glGenFramebuffers(1, &name);
        return name;
    }
    static void release(GLuint name) { glDeleteFramebuffers(1, &name); }
};
struct VertexArrayKind {
    static GLuint make() {
        GLuint name = 0;
        glGenVertexArrays(1, &name);
        return name;
    }
    static void release(GLuint name) { glDeleteVertexArrays(1, &name); }
};

using GlBuffer = GlHandle<BufferKind>;
using GlTexture = GlHandle<TextureKind>;
using GlFramebuffer = GlHandle<FramebufferKind>;
using GlVertexArray = GlHandle<VertexArrayKind>;

}  // namespace rinceau
