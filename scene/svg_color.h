#pragma once
// Colours and paints in text.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "scene/style.h"

namespace rinceau {

/// A colour with its opacity, or the keyword currentColor.
struct ParsedColor {
    Color color;
    double opacity = 1;
    bool current = false;  ///< currentColor: `color` and `opacity` mean nothing

    friend constexpr bool operator==(const ParsedColor&, const ParsedColor&) = default;
};

/// #rgb, #rgba, #rrggbb, #rrggbbaa, rgb(), rgba(), hsl(), hsla() (commas or spaces, percentages, "/ alpha"), the names
/// of CSS, "transparent" (black of opacity 0), currentColor; any case. An ICC colour after the colour is ignored.
std::optional<ParsedColor> parse_color(std::string_view text);

enum class PaintKind : std::uint8_t { none, color, reference, context_fill, context_stroke };

/// The value of `fill` or `stroke`.
struct ParsedPaint {
    PaintKind kind = PaintKind::none;
    ParsedColor color;      ///< kind color
    std::string reference;  ///< kind reference: what stands in url(...), without quotes ("#id")
    bool has_fallback = false;
    PaintKind fallback = PaintKind::none;  ///< none or color
    ParsedColor fallback_color;
};

std::optional<ParsedPaint> parse_paint(std::string_view text);

/// What stands in "url(...)" at the front of the text, without white space and quotes.
std::optional<std::string> parse_url(std::string_view text);

}  // namespace rinceau
