#include "exports/plain_color.h"

#include <algorithm>
#include <cmath>

namespace rinceau {

namespace {

/// Sums of a gradient along its axis, colours weighted by opacity.
struct Sums {
    double red = 0, green = 0, blue = 0, opacity = 0;

    void add(const GradientStop& stop, double length) {
        const double weight = length * stop.opacity;
        red += weight * stop.color.red;
        green += weight * stop.color.green;
        blue += weight * stop.color.blue;
        opacity += weight;
    }
};

PlainColor mean_color(const std::vector<GradientStop>& stops) {
    Sums sums;
    // each half of a stretch belongs to the stop at its end
    sums.add(stops.front(), stops.front().offset);
    for (std::size_t i = 1; i < stops.size(); ++i) {
        const double half = (stops[i].offset - stops[i - 1].offset) / 2;
        sums.add(stops[i - 1], half);
        sums.add(stops[i], half);
    }
    sums.add(stops.back(), 1 - stops.back().offset);
    if (!(sums.opacity > 0)) return {stops.front().color, 0};
    const auto channel = [&](double sum) {
        return static_cast<std::uint8_t>(std::lround(std::clamp(sum / sums.opacity, 0.0, 255.0)));
    };
    return {{channel(sums.red), channel(sums.green), channel(sums.blue)}, std::min(sums.opacity, 1.0)};
}

}  // namespace

std::optional<PlainColor> plain_color(const Paint& paint) {
    if (const Color* color = std::get_if<Color>(&paint)) return PlainColor{*color};
    if (is_gradient(paint)) return mean_color(std::get<std::shared_ptr<const Gradient>>(paint)->stops);
    return std::nullopt;
}

std::string hex_text(Color color) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::string text = "#";
    for (const unsigned channel : {unsigned{color.red}, unsigned{color.green}, unsigned{color.blue}}) {
        text += digits[channel >> 4U];
        text += digits[channel & 15U];
    }
    return text;
}

}  // namespace rinceau
