#pragma once
// Pictures as pixels, and when two of them are the same to the eye.

#include <cstdint>
#include <vector>

namespace rinceau {

/// Rows from the top, three bytes (red, green, blue) a pixel.
struct Picture {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgb;
};

/// Rows from the top, four bytes (red, green, blue, opacity) a pixel; the colours are multiplied by the opacity.
struct TransparentPicture {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;
};

/// Share of the inked pixels (of either picture; ink is what is not nearly white) that differ by more than an eighth of the
/// range, in some channel, from every pixel of the other picture within one pixel. 0 = the same; 1 if the sizes differ.
double picture_difference(const Picture& a, const Picture& b);

}  // namespace rinceau
