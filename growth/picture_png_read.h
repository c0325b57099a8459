#pragma once
// Pictures from PNG files of any colour type, with 8 or 16 bits.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "scene/picture.h"

namespace rinceau {

/// Colours over white. Throws InputError in the name of `label` if the bytes are no PNG, LimitError for more than 16 million
/// pixels.
Picture read_picture_png(std::string_view bytes, const std::string& label);

/// Brightness and opacity of each pixel, row by row from the top.
struct GreyPixels {
    struct Pixel {
        std::uint8_t grey = 0, opacity = 0;
    };
    int width = 0, height = 0;
    std::vector<Pixel> pixels;
};

/// Throws as read_picture_png.
GreyPixels read_grey_png(std::string_view bytes, const std::string& label);

}  // namespace rinceau
