#include "editor/gl/picture_renderer.h"

#include <epoxy/gl.h>

#include <algorithm>

namespace rinceau {

struct PictureRenderer::Parts {
    unsigned texture = 0;
    unsigned framebuffer = 0;
    std::string shortcoming;
    int width = 0;
    int height = 0;
};

PictureRenderer::PictureRenderer() : parts_(std::make_unique<Parts>()) {
    glGenTextures(1, &parts_->texture);
    glGenFramebuffers(1, &parts_->framebuffer);
}

PictureRenderer::~PictureRenderer() {
    glDeleteFramebuffers(1, &parts_->framebuffer);
    glDeleteTextures(1, &parts_->texture);
}

bool PictureRenderer::refining() const { return false; }
const std::string& PictureRenderer::shortcoming() const { return parts_->shortcoming; }

unsigned PictureRenderer::draw(const std::shared_ptr<const DerivedPicture>& picture, const ViewTransform& view,
                               const PictureEmphasis&, const PictureDrawOptions&) {
    const int width = std::max(1, static_cast<int>(view.size.x));
    const int height = std::max(1, static_cast<int>(view.size.y));
    glBindTexture(GL_TEXTURE_2D, parts_->texture);
    if (width != parts_->width || height != parts_->height) {
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        parts_->width = width;
        parts_->height = height;
    }
    glBindFramebuffer(GL_FRAMEBUFFER, parts_->framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, parts_->texture, 0);
    glViewport(0, 0, width, height);
    glClearColor(1, 1, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    if (picture) {
        glEnable(GL_SCISSOR_TEST);
        for (const PictureItem& item : picture->items) {
            const Point at = to_canvas(view, item.pose.translation);
            glScissor(static_cast<int>(at.x) - 2, height - static_cast<int>(at.y) - 2, 4, 4);
            glClearColor(0, 0, 0, 1);
            glClear(GL_COLOR_BUFFER_BIT);
        }
        glDisable(GL_SCISSOR_TEST);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    return parts_->texture;
}

}  // namespace rinceau
