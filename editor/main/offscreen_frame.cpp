#include "editor/main/offscreen_frame.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cstddef>

namespace rinceau {
namespace {

Picture read_pixels(unsigned framebuffer, int width, int height) {
    const auto row = static_cast<std::size_t>(width) * 3;
    Picture picture{width, height, std::vector<std::uint8_t>(row * static_cast<std::size_t>(height))};
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, picture.rgb.data());
    // OpenGL's rows go up.
    for (std::size_t low = 0, high = static_cast<std::size_t>(height); low + 1 < high; ++low) {
        --high;
        const auto at = [&](std::size_t line) { return picture.rgb.begin() + static_cast<std::ptrdiff_t>(line * row); };
        std::swap_ranges(at(low), at(low + 1), at(high));
    }
    return picture;
}

}  // namespace

OffscreenFrame::OffscreenFrame(int width, int height) : width_(width), height_(height) {
    glGenRenderbuffers(1, &pixels_);
    glBindRenderbuffer(GL_RENDERBUFFER, pixels_);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width, height);
    glGenFramebuffers(1, &framebuffer_);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, pixels_);
}

OffscreenFrame::~OffscreenFrame() {
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteRenderbuffers(1, &pixels_);
}

void OffscreenFrame::bind() const { glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_); }

Picture OffscreenFrame::read() const { return read_pixels(framebuffer_, width_, height_); }

Picture picture_of_texture(unsigned texture, int width, int height) {
    unsigned framebuffer = 0;
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    Picture picture = read_pixels(framebuffer, width, height);
    glDeleteFramebuffers(1, &framebuffer);
    return picture;
}

}  // namespace rinceau
