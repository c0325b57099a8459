#include "scene/svg_color.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "geometry/angle.h"
#include "scene/svg_color_names.h"
#include "scene/svg_number.h"

namespace rinceau {

namespace {

std::uint8_t channel(double value) { return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0))); }

Color from_rgb(std::uint32_t rgb) {
    return {static_cast<std::uint8_t>(rgb >> 16 & 255), static_cast<std::uint8_t>(rgb >> 8 & 255),
            static_cast<std::uint8_t>(rgb & 255)};
}

std::optional<int> hex_digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    return std::nullopt;
}

// The digits behind '#': 3, 4, 6 or 8 of them.
std::optional<ParsedColor> hex_color(std::string_view digits) {
    const bool is_short = digits.size() == 3 || digits.size() == 4;
    if (!is_short && digits.size() != 6 && digits.size() != 8) return std::nullopt;
    std::vector<std::uint8_t> channels;
    const std::size_t step = is_short ? 1 : 2;
    for (std::size_t i = 0; i < digits.size(); i += step) {
        const std::optional<int> high = hex_digit(digits[i]);
        const std::optional<int> low = hex_digit(digits[i + step - 1]);
        if (!high || !low) return std::nullopt;
        channels.push_back(static_cast<std::uint8_t>(*high * 16 + *low));
    }
    return ParsedColor{{channels[0], channels[1], channels[2]}, channels.size() > 3 ? channels[3] / 255.0 : 1.0};
}

struct ColorArgument {
    double value = 0;
    std::string unit;  ///< "%", "deg", ... or empty
};

// What stands between the brackets, separated by commas, white space or a slash.
std::optional<std::vector<ColorArgument>> color_arguments(std::string_view text) {
    TextCursor cursor{trimmed(text)};
    std::vector<ColorArgument> arguments;
    while (!cursor.at_end()) {
        const std::optional<double> value = read_number(cursor);
        if (!value) return std::nullopt;
        const std::size_t start = cursor.at;
        while (cursor.peek() == '%' || (cursor.peek() >= 'a' && cursor.peek() <= 'z')) ++cursor.at;
        arguments.push_back({*value, std::string(cursor.text.substr(start, cursor.at - start))});
        const std::size_t end = cursor.at;
        const bool comma = skip_comma_space(cursor);
        if (!comma && skip_token(cursor, "/")) skip_space(cursor);
        if (cursor.at_end() && cursor.at > end) return std::nullopt;
    }
    if (arguments.size() != 3 && arguments.size() != 4) return std::nullopt;
    return arguments;
}

double share_of(const ColorArgument& argument) { return argument.unit == "%" ? argument.value / 100 : argument.value; }

std::optional<Color> rgb_color(const std::vector<ColorArgument>& arguments) {
    std::array<std::uint8_t, 3> channels{};
    for (std::size_t i = 0; i < 3; ++i) {
        const ColorArgument& argument = arguments[i];
        if (!argument.unit.empty() && argument.unit != "%") return std::nullopt;
        channels[i] = channel(argument.unit == "%" ? argument.value * 2.55 : argument.value);
    }
    return Color{channels[0], channels[1], channels[2]};
}

std::optional<double> hue_degrees(const ColorArgument& argument) {
    if (argument.unit.empty() || argument.unit == "deg") return argument.value;
    if (argument.unit == "rad") return degrees(argument.value);
    if (argument.unit == "grad") return argument.value * 0.9;
    if (argument.unit == "turn") return argument.value * 360;
    return std::nullopt;
}

// CSS Color 4, section 7.1.
std::optional<Color> hsl_color(const std::vector<ColorArgument>& arguments) {
    const std::optional<double> hue = hue_degrees(arguments[0]);
    if (!hue || arguments[1].unit != "%" || arguments[2].unit != "%") return std::nullopt;
    const double saturation = std::clamp(arguments[1].value / 100, 0.0, 1.0);
    const double lightness = std::clamp(arguments[2].value / 100, 0.0, 1.0);
    const double chroma = saturation * std::min(lightness, 1 - lightness);
    const auto value = [&](double n) {
        double sector = std::fmod(n + *hue / 30, 12.0);
        if (sector < 0) sector += 12;
        return channel(255 * (lightness - chroma * std::max(-1.0, std::min({sector - 3, 9 - sector, 1.0}))));
    };
    return Color{value(0), value(8), value(4)};
}

std::optional<ParsedColor> color_function(std::string_view name, std::string_view inside) {
    const std::optional<std::vector<ColorArgument>> arguments = color_arguments(inside);
    if (!arguments) return std::nullopt;
    std::optional<Color> color;
    if (name == "rgb" || name == "rgba") color = rgb_color(*arguments);
    if (name == "hsl" || name == "hsla") color = hsl_color(*arguments);
    if (!color) return std::nullopt;
    return ParsedColor{*color, arguments->size() > 3 ? std::clamp(share_of((*arguments)[3]), 0.0, 1.0) : 1.0};
}

std::optional<ParsedColor> named_color(std::string_view name) {
    if (name == "transparent") return ParsedColor{{}, 0};
    if (name == "currentcolor") return ParsedColor{{}, 1, true};
    const auto found = std::lower_bound(color_names.begin(), color_names.end(), name,
                                        [](const NamedColor& named, std::string_view text) { return named.name < text; });
    if (found == color_names.end() || found->name != name) return std::nullopt;
    return ParsedColor{from_rgb(found->rgb)};
}

// The text behind the closing bracket of "url(...)"; whole text if there is none.
std::string_view after_url(std::string_view text) {
    const std::size_t close = text.find(')');
    return close == std::string_view::npos ? text : trimmed(text.substr(close + 1));
}

bool starts_url(std::string_view text) { return lower_case(text.substr(0, 4)) == "url("; }

}  // namespace

std::optional<ParsedColor> parse_color(std::string_view text) {
    std::string lower = lower_case(trimmed(text));
    if (const std::size_t icc = lower.find("icc-color("); icc != std::string::npos && icc > 0) lower.resize(icc);
    const std::string_view color = trimmed(lower);
    if (color.empty()) return std::nullopt;
    if (color.front() == '#') return hex_color(color.substr(1));
    const std::size_t open = color.find('(');
    if (open == std::string_view::npos) return named_color(color);
    if (color.back() != ')') return std::nullopt;
    return color_function(trimmed(color.substr(0, open)), color.substr(open + 1, color.size() - open - 2));
}

std::optional<std::string> parse_url(std::string_view text) {
    text = trimmed(text);
    if (!starts_url(text)) return std::nullopt;
    const std::size_t close = text.find(')');
    if (close == std::string_view::npos) return std::nullopt;
    std::string_view inside = trimmed(text.substr(4, close - 4));
    const bool quoted =
        inside.size() >= 2 && (inside.front() == '"' || inside.front() == '\'') && inside.back() == inside.front();
    if (quoted) inside = trimmed(inside.substr(1, inside.size() - 2));
    return std::string(inside);
}

std::optional<ParsedPaint> parse_paint(std::string_view text) {
    text = trimmed(text);
    const std::string keyword = lower_case(text);
    ParsedPaint paint;
    if (keyword == "none") return paint;
    if (keyword == "context-fill" || keyword == "context-stroke") {
        paint.kind = keyword == "context-fill" ? PaintKind::context_fill : PaintKind::context_stroke;
        return paint;
    }
    if (!starts_url(text)) {
        const std::optional<ParsedColor> color = parse_color(text);
        if (!color) return std::nullopt;
        paint.kind = PaintKind::color;
        paint.color = *color;
        return paint;
    }
    const std::optional<std::string> reference = parse_url(text);
    if (!reference) return std::nullopt;
    paint.kind = PaintKind::reference;
    paint.reference = *reference;
    const std::string_view fallback = after_url(text);
    if (const std::optional<ParsedColor> color = parse_color(fallback)) {
        paint.has_fallback = true;
        paint.fallback = PaintKind::color;
        paint.fallback_color = *color;
    } else {
        paint.has_fallback = lower_case(fallback) == "none";
    }
    return paint;
}

}  // namespace rinceau
