#include "scene/svg_units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "scene/svg_number.h"

namespace rinceau {

namespace {

constexpr double px_per_inch = 96;
constexpr double medium_font = 16;
constexpr double font_step = 1.2;  // "larger" and "smaller"

struct FixedUnit {
    std::string_view name;
    double px;
};
constexpr std::array<FixedUnit, 8> fixed_units{{{"", 1},
                                                {"px", 1},
                                                {"pt", px_per_inch / 72},
                                                {"pc", px_per_inch / 6},
                                                {"in", px_per_inch},
                                                {"cm", px_per_inch / 2.54},
                                                {"mm", px_per_inch / 25.4},
                                                {"q", px_per_inch / 101.6}}};

// CSS Fonts, absolute-size keywords, as multiples of medium.
constexpr std::array<std::pair<std::string_view, double>, 8> font_keywords{{{"xx-small", 3.0 / 5},
                                                                            {"x-small", 3.0 / 4},
                                                                            {"small", 8.0 / 9},
                                                                            {"medium", 1},
                                                                            {"large", 6.0 / 5},
                                                                            {"x-large", 3.0 / 2},
                                                                            {"xx-large", 2},
                                                                            {"xxx-large", 3}}};

double percent_base(const UnitContext& context, LengthAxis axis) {
    if (axis == LengthAxis::x) return context.width;
    if (axis == LengthAxis::y) return context.height;
    return std::sqrt((context.width * context.width + context.height * context.height) / 2);
}

// One of this unit in px.
std::optional<double> unit_size(std::string_view unit, const UnitContext& context, LengthAxis axis) {
    for (const FixedUnit& fixed : fixed_units) {
        if (unit == fixed.name) return fixed.px;
    }
    if (unit == "%") return percent_base(context, axis) / 100;
    if (unit == "em") return context.font_size;
    if (unit == "ex" || unit == "ch") return context.font_size / 2;
    if (unit == "rem") return context.root_font_size;
    if (unit == "vw") return context.page_width / 100;
    if (unit == "vh") return context.page_height / 100;
    if (unit == "vmin") return std::min(context.page_width, context.page_height) / 100;
    if (unit == "vmax") return std::max(context.page_width, context.page_height) / 100;
    return std::nullopt;
}

std::optional<double> finite(double value) { return std::isfinite(value) ? std::optional(value) : std::nullopt; }

}  // namespace

std::optional<double> parse_length(std::string_view text, const UnitContext& context, LengthAxis axis) {
    TextCursor cursor{trimmed(text)};
    const std::optional<double> number = read_number(cursor);
    if (!number) return std::nullopt;
    const std::optional<double> unit = unit_size(lower_case(cursor.text.substr(cursor.at)), context, axis);
    return unit ? finite(*number * *unit) : std::nullopt;
}

std::optional<std::vector<double>> parse_lengths(std::string_view text, const UnitContext& context, LengthAxis axis) {
    TextCursor cursor{trimmed(text)};
    std::vector<double> lengths;
    while (!cursor.at_end()) {
        const std::size_t start = cursor.at;
        while (!cursor.at_end() && cursor.peek() != ',' && !is_svg_space(cursor.peek())) ++cursor.at;
        const std::optional<double> length = parse_length(cursor.text.substr(start, cursor.at - start), context, axis);
        if (!length) return std::nullopt;
        lengths.push_back(*length);
        if (skip_comma_space(cursor) && cursor.at_end()) return std::nullopt;
    }
    return lengths;
}

std::optional<double> parse_number(std::string_view text) {
    TextCursor cursor{trimmed(text)};
    const std::optional<double> number = read_number(cursor);
    return number && cursor.at_end() ? number : std::nullopt;
}

std::optional<double> parse_share(std::string_view text) {
    text = trimmed(text);
    if (text.empty() || text.back() != '%') return parse_number(text);
    text.remove_suffix(1);
    if (text.empty() || is_svg_space(text.back())) return std::nullopt;
    const std::optional<double> percent = parse_number(text);
    return percent ? std::optional(*percent / 100) : std::nullopt;
}

std::optional<double> parse_opacity(std::string_view text) {
    const std::optional<double> share = parse_share(text);
    return share ? std::optional(std::clamp(*share, 0.0, 1.0)) : std::nullopt;
}

std::optional<double> parse_font_size(std::string_view text, const UnitContext& parent) {
    const std::string keyword = lower_case(trimmed(text));
    for (const auto& [name, factor] : font_keywords) {
        if (keyword == name) return factor * medium_font;
    }
    if (keyword == "larger") return parent.font_size * font_step;
    if (keyword == "smaller") return parent.font_size / font_step;
    UnitContext of_font = parent;
    of_font.width = parent.font_size;
    const std::optional<double> size = parse_length(text, of_font, LengthAxis::x);
    return size && *size >= 0 ? size : std::nullopt;
}

}  // namespace rinceau
