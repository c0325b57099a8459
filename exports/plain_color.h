#pragma once
// One colour for a paint, for formats that have no gradients.

#include <optional>
#include <string>

#include "scene/style.h"

namespace rinceau {

/// A colour and how much of it covers what lies below.
struct PlainColor {
    Color color;
    double opacity = 1;  ///< 0..1
};

/// A gradient's mean along its axis, offset 0 to 1, every stop as strong as it is opaque. Nothing for `none`.
std::optional<PlainColor> plain_color(const Paint& paint);

constexpr bool is_gradient(const Paint& paint) { return std::holds_alternative<std::shared_ptr<const Gradient>>(paint); }

/// "#rrggbb"
std::string hex_text(Color color);

}  // namespace rinceau
