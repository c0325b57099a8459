#pragma once
// A program of the graphics card.

#include <epoxy/gl.h>

#include <string>
#include <string_view>

namespace rinceau {

class GlProgram {
  public:
    /// Throws std::runtime_error with the compiler's words.
    GlProgram(std::string_view vertex_source, std::string_view fragment_source);
    ~GlProgram();
    GlProgram(const GlProgram&) = delete;
    GlProgram& operator=(const GlProgram&) = delete;

    void use() const { glUseProgram(name_); }
    /// -1 if the program does not use it: setting it then does nothing.
    GLint uniform(const char* name) const { return glGetUniformLocation(name_, name); }

  private:
    GLuint name_ = 0;
};

}  // namespace rinceau
