#include "hidden_window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <epoxy/gl.h>

#include <algorithm>
#include <stdexcept>

namespace rinceau::test {

struct HiddenWindow::Handle {
    GLFWwindow* window = nullptr;
    ~Handle() {
        if (window != nullptr) glfwDestroyWindow(window);  // the connection to the display stays, for the next one
    }
};

HiddenWindow::HiddenWindow() : handle_(std::make_unique<Handle>()) {
    if (glfwInit() != GLFW_TRUE) throw std::runtime_error("no display");
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    handle_->window = glfwCreateWindow(16, 16, "", nullptr, nullptr);
    if (handle_->window == nullptr) throw std::runtime_error("no OpenGL 3.3");
    glfwMakeContextCurrent(handle_->window);
}

HiddenWindow::~HiddenWindow() = default;

std::vector<std::uint8_t> texture_pixels(unsigned texture, int width, int height) {
    const auto row = 4 * static_cast<std::ptrdiff_t>(width);
    std::vector<std::uint8_t> upward(static_cast<std::size_t>(row * height));
    glBindTexture(GL_TEXTURE_2D, texture);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, upward.data());
    std::vector<std::uint8_t> downward(upward.size());
    for (std::ptrdiff_t y = 0; y < height; ++y)
        std::copy_n(upward.begin() + y * row, row, downward.begin() + (height - 1 - y) * row);
    return downward;
}

void finish_drawing() { glFinish(); }

bool opengl_complains() { return glGetError() != GL_NO_ERROR; }

}  // namespace rinceau::test
