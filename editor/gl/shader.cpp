#include "editor/gl/shader.h"

#include <array>
#include <stdexcept>

namespace rinceau {
namespace {

constexpr GLsizei longest_log = 2048;

GLuint compiled(GLenum kind, std::string_view source) {
    const GLuint shader = glCreateShader(kind);
    const char* text = source.data();
    const auto length = static_cast<GLint>(source.size());
    glShaderSource(shader, 1, &text, &length);
    glCompileShader(shader);
    GLint good = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
    if (good == GL_TRUE) return shader;
    std::array<char, longest_log> log{};
    glGetShaderInfoLog(shader, longest_log, nullptr, log.data());
    glDeleteShader(shader);
    throw std::runtime_error(std::string("OpenGL cannot compile a shader: ") + log.data());
}

}  // namespace

GlProgram::GlProgram(std::string_view vertex_source, std::string_view fragment_source) {
    const GLuint vertex = compiled(GL_VERTEX_SHADER, vertex_source);
    const GLuint fragment = compiled(GL_FRAGMENT_SHADER, fragment_source);
    name_ = glCreateProgram();
    glAttachShader(name_, vertex);
    glAttachShader(name_, fragment);
    glLinkProgram(name_);
    glDeleteShader(vertex);
    glDeleteShader(fragment);
    GLint good = GL_FALSE;
    glGetProgramiv(name_, GL_LINK_STATUS, &good);
    if (good == GL_TRUE) return;
    std::array<char, longest_log> log{};
    glGetProgramInfoLog(name_, longest_log, nullptr, log.data());
    glDeleteProgram(name_);
    throw std::runtime_error(std::string("OpenGL cannot link a program: ") + log.data());
}

GlProgram::~GlProgram() { glDeleteProgram(name_); }

}  // namespace rinceau
