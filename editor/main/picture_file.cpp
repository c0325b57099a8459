#include "editor/main/picture_file.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <utility>

#include "editor/effects/read_document.h"
#include "editor/gl/picture_renderer.h"
#include "editor/main/offscreen_frame.h"
#include "editor/main/window.h"
#include "files/files.h"
#include "scene/svg_raster.h"

namespace rinceau {
namespace {

DerivedPicture picture_of(const Document& document, bool as_drawing) {
    if (!document.drawing) return derive_picture(document);
    if (as_drawing) return drawing_picture(*document.drawing);
    return derive_picture(with_grammar(document, analyze(*document.drawing, document.analysis).grammar));
}

/// The canvas fills the picture from its upper left corner on.
ViewTransform view_of(const Box& canvas, int width_in_pixels) {
    const double zoom = width_in_pixels / width(canvas);
    const double height_in_pixels = std::max(1.0, std::ceil(height(canvas) * zoom));
    return {{center(canvas).x, canvas.high.y - 0.5 * height_in_pixels / zoom},
            zoom,
            {static_cast<double>(width_in_pixels), height_in_pixels}};
}

Picture drawn(DerivedPicture picture, int width_in_pixels) {
    const Box canvas = picture.grammar->canvas;
    if (!(width(canvas) > 0 && height(canvas) > 0)) throw std::runtime_error("the drawing has no size");
    const ViewTransform view = view_of(canvas, width_in_pixels);
    PictureRenderer renderer;
    PictureDrawOptions options;
    options.finish = true;
    options.surround.ground = {255, 255, 255};
    const unsigned texture = renderer.draw(std::make_shared<const DerivedPicture>(std::move(picture)), view, {}, options);
    if (!renderer.shortcoming().empty()) std::fprintf(stderr, "%s\n", renderer.shortcoming().c_str());
    return picture_of_texture(texture, static_cast<int>(view.size.x), static_cast<int>(view.size.y));
}

}  // namespace

int write_picture_file(const EditorOptions& options) {
    try {
        constexpr int any_size = 64;  // nobody sees the window
        const Window window(any_size, any_size, false);
        const FileOpened file = read_document(options.file);
        const Picture picture = drawn(picture_of(file.document, options.as_drawing), options.picture_width);
        write_output(options.picture, picture_to_png(picture));
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s: %s\n", options.file.c_str(), error.what());
        return 1;
    }
}

}  // namespace rinceau
