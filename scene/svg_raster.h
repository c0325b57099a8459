#pragma once
// Pictures of an SVG document through librsvg and cairo: PNG and PDF.

#include <string>
#include <string_view>

#include "scene/picture.h"

namespace rinceau {

/// PNG bytes of an SVG document, `width` pixels wide (0 = its own size), over transparent ground.
/// Throws InputError if librsvg refuses the document, LimitError if the picture would exceed 32767 pixels a side.
std::string svg_to_png(std::string_view svg, int width = 0);

/// The same picture over white, as pixels.
Picture svg_to_picture(std::string_view svg, int width);

/// PNG bytes of a picture. Throws LimitError if it exceeds 32767 pixels a side or has no pixel.
std::string picture_to_png(const Picture& picture);

/// The same picture over transparent ground, as pixels.
TransparentPicture svg_to_transparent_picture(std::string_view svg, int width = 0);

/// PDF bytes of an SVG document, one page of its size (96 px = 72 pt).
std::string svg_to_pdf(std::string_view svg);

}  // namespace rinceau
