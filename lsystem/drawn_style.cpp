#include "lsystem/drawn_style.h"

#include <array>
#include <cmath>

#include "scene/oklab.h"

namespace rinceau {

int drawn_style_number(const Grammar& grammar, const Placement& placement) {
    return placement.style != 0 ? placement.style : grammar.terminals[static_cast<std::size_t>(placement.terminal)].style;
}

Color distinct_color(int index) {
    const double golden_angle = pi * (3 - std::sqrt(5.0));
    constexpr std::array lightness{0.62, 0.78, 0.47};  // all of them seen on white
    constexpr double chroma = 0.15;                    // as much as sRGB holds at these lightnesses for most hues
    constexpr double first_hue = 0.5;                  // a red
    const Complex hue = polar(chroma, first_hue + golden_angle * index);
    return from_oklab({lightness[static_cast<std::size_t>(index) % lightness.size()], hue});
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
