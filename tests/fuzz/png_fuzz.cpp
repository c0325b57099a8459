// Pictures that say where to grow, and how.

#include "growth/picture_png_read.h"
#include "tests/fuzz/fuzz_target.h"

void rinceau::take_input(std::string_view bytes) {
    Picture picture;
    const bool color = is_taken([&] { picture = read_picture_png(bytes, "any.png"); });
    GreyPixels grey;
    require(is_taken([&] { grey = read_grey_png(bytes, "any.png"); }) == color, "colours and grey are of the same picture");
    if (!color) return;
    require(grey.width == picture.width && grey.height == picture.height, "colours and grey are of the same size");
    require(grey.pixels.size() == static_cast<std::size_t>(grey.width) * static_cast<std::size_t>(grey.height),
            "every pixel is there");
}
