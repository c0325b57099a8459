#include "scene/oklab.h"

#include <algorithm>
#include <cmath>

namespace rinceau {
namespace {

/// Linear light 0..1 -> sRGB 0..255 (IEC 61966-2-1), and back.
std::uint8_t to_channel(double light) {
    const double clamped = std::clamp(light, 0.0, 1.0);
    const double encoded = clamped <= 0.0031308 ? 12.92 * clamped : 1.055 * std::pow(clamped, 1 / 2.4) - 0.055;
    return static_cast<std::uint8_t>(std::lround(255 * encoded));
}
double to_light(std::uint8_t channel) {
    const double encoded = channel / 255.0;
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

}  // namespace

OklabColor to_oklab(Color color) {
    const double red = to_light(color.red), green = to_light(color.green), blue = to_light(color.blue);
    const double l = std::cbrt(0.4122214708 * red + 0.5363325363 * green + 0.0514459929 * blue);
    const double m = std::cbrt(0.2119034982 * red + 0.6806995451 * green + 0.1073969566 * blue);
    const double s = std::cbrt(0.0883024619 * red + 0.2817188376 * green + 0.6299787005 * blue);
    return {
        0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
        {1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s, 0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s}};
}

Color from_oklab(const OklabColor& color) {
    const auto [a, b] = color.chroma;
    const double l = std::pow(color.lightness + 0.3963377774 * a + 0.2158037573 * b, 3);
    const double m = std::pow(color.lightness - 0.1055613458 * a - 0.0638541728 * b, 3);
    const double s = std::pow(color.lightness - 0.0894841775 * a - 1.2914855480 * b, 3);
    return {to_channel(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
            to_channel(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
            to_channel(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

}  // namespace rinceau
