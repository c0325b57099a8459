#include "growth/surface/shape_palette.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rinceau {

namespace {

constexpr std::array<Color, 12> palette{Color{245, 243, 238}, Color{96, 142, 62},  Color{176, 58, 46},
                                        Color{52, 101, 164},  Color{208, 164, 78}, Color{110, 78, 52},
                                        Color{140, 140, 140}, Color{40, 38, 36},   Color{156, 190, 98},
                                        Color{126, 84, 150},  Color{222, 128, 48}, Color{42, 140, 138}};

std::uint8_t channel(double value) { return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0))); }

}  // namespace

Color palette_color(double number) {
    const double count = palette.size();
    const double wrapped = std::fmod(std::floor(number), count);
    return palette[static_cast<std::size_t>(wrapped < 0 ? wrapped + count : wrapped)];
}

Color color_of_channels(double red, double green, double blue) { return {channel(red), channel(green), channel(blue)}; }

}  // namespace rinceau
