#include "lsystem/drawn_style.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rinceau {

int drawn_style_number(const Grammar& grammar, const Placement& placement) {
    return placement.style != 0 ? placement.style : grammar.terminals[static_cast<std::size_t>(placement.terminal)].style;
}

namespace {

/// Linear light 0..1 -> sRGB 0..255 (IEC 61966-2-1).
std::uint8_t channel(double light) {
    const double clamped = std::clamp(light, 0.0, 1.0);
    const double encoded = clamped <= 0.0031308 ? 12.92 * clamped : 1.055 * std::pow(clamped, 1 / 2.4) - 0.055;
    return static_cast<std::uint8_t>(std::lround(255 * encoded));
}

/// OKLab -> sRGB (Ottosson 2020, "A perceptual color space for image processing").
Color from_oklab(double lightness, double a, double b) {
    const double l = std::pow(lightness + 0.3963377774 * a + 0.2158037573 * b, 3);
    const double m = std::pow(lightness - 0.1055613458 * a - 0.0638541728 * b, 3);
    const double s = std::pow(lightness - 0.0894841775 * a - 1.2914855480 * b, 3);
    return {channel(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
            channel(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
            channel(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

}  // namespace

Color distinct_color(int index) {
    const double golden_angle = pi * (3 - std::sqrt(5.0));
    constexpr std::array lightness{0.62, 0.78, 0.47};  // all of them seen on white
    constexpr double chroma = 0.15;                    // as much as sRGB holds at these lightnesses for most hues
    constexpr double first_hue = 0.5;                  // a red
    const Complex hue = polar(chroma, first_hue + golden_angle * index);
    return from_oklab(lightness[static_cast<std::size_t>(index) % lightness.size()], hue.x, hue.y);
}

Style repainted(Style style, const Repaint& repaint) {
    if (repaint.fill && std::holds_alternative<Color>(style.fill)) style.fill = *repaint.fill;
    if (repaint.stroke && std::holds_alternative<Color>(style.stroke.paint)) style.stroke.paint = *repaint.stroke;
    return style;
}

Style recolored(Style style, Color color) {
    if (!std::holds_alternative<NoPaint>(style.fill)) style.fill = color;
    if (!std::holds_alternative<NoPaint>(style.stroke.paint)) style.stroke.paint = color;
    return style;
}

}  // namespace rinceau
