#pragma once
// Lengths, percentages and opacities of SVG and CSS, resolved to px and plain numbers.

#include <optional>
#include <string_view>
#include <vector>

namespace rinceau {

/// What relative units refer to; all in px.
struct UnitContext {
    double width = 100, height = 100;            ///< of the nearest viewport, in its user units: 100 %
    double font_size = 16;                       ///< em; ex and ch are half of it
    double root_font_size = 16;                  ///< rem
    double page_width = 100, page_height = 100;  ///< of the outermost viewport: vw, vh, vmin, vmax
};

/// What a percentage is a share of: the viewport's width, its height, or sqrt((w^2 + h^2) / 2).
enum class LengthAxis { x, y, diagonal };

/// "12", "1.5em", "3 %" is not one: a number with an optional unit (any case). Nothing if it is not a length
/// (keywords as "auto" too) or not finite.
std::optional<double> parse_length(std::string_view text, const UnitContext& context, LengthAxis axis);
/// Lengths separated by white space and commas; nothing if one of them is faulty. An empty text gives an empty list.
std::optional<std::vector<double>> parse_lengths(std::string_view text, const UnitContext& context, LengthAxis axis);
/// A plain finite number and nothing else.
std::optional<double> parse_number(std::string_view text);
/// A number or a percentage as a share of 1, not clamped (gradient offsets, opacities).
std::optional<double> parse_share(std::string_view text);
/// A share clamped to [0, 1].
std::optional<double> parse_opacity(std::string_view text);
/// font-size: a length, a percentage of `parent.font_size`, or a keyword (medium = 16 px, larger, smaller, ...).
std::optional<double> parse_font_size(std::string_view text, const UnitContext& parent);

}  // namespace rinceau
