#include "lsystem/fit_box.h"

#include <charconv>
#include <cmath>
#include <numbers>

#include "lsystem/turtle_step.h"

namespace rinceau {

namespace {

double rounded_at(double value, int decimals) {
    constexpr std::size_t longest = 400;  // a double in fixed notation has 309 digits before the point
    char text[longest];
    const auto end = std::to_chars(text, text + longest, value, std::chars_format::fixed, decimals).ptr;
    double result = value;
    std::from_chars(text, end, result);
    return result == 0 ? 0 : result;  // no negative zero
}

ModuleTemplate command(const char* symbol, double value) { return {symbol, {number_expression(value)}, {}}; }

void append_turn(ModuleTemplates& string, double degrees) {
    if (degrees > 0) string.push_back(command("+", degrees));
    if (degrees < 0) string.push_back(command("-", -degrees));
}

}  // namespace

double rounded_in(double value, double size, int digits) {
    if (!(size > 0) || !std::isfinite(size) || !std::isfinite(value)) return value;
    const int decimals = digits - 1 - static_cast<int>(std::floor(std::log10(size)));
    return decimals < 0 ? std::round(value) : rounded_at(value, decimals);
}

double rounded_factor(double value, int digits) { return rounded_in(value, std::abs(value), digits); }

double fitted_scale(const Box& content, const Box& place, ReplaceFit fit) {
    if (fit == ReplaceFit::none || is_empty(content) || is_empty(place)) return 1;
    const auto ratio = [](double whole, double part) { return whole > 0 && part > 0 ? whole / part : 0; };
    const double across = ratio(width(place), width(content));
    const double up = ratio(height(place), height(content));
    double scale = across;
    if (fit == ReplaceFit::inside) scale = across > 0 && up > 0 ? std::min(across, up) : std::max(across, up);
    if (fit == ReplaceFit::cover) scale = std::max(across, up);
    if (fit == ReplaceFit::width) scale = across > 0 ? across : up;
    if (fit == ReplaceFit::height) scale = up > 0 ? up : across;
    return scale > 0 ? scale : 1;
}

Similarity fitted(const Box& content, const Box& place, ReplaceFit fit) {
    if (is_empty(content) || is_empty(place)) return {};
    const double scale = rounded_factor(fitted_scale(content, place, fit));
    return translate(center(place)) * scale_by(scale) * translate(-center(content));
}

ModuleTemplates turtle_modules(const Similarity& map, double size, int digits) {
    const TurtleStep step = to_turtle_step(map);
    constexpr double degrees = 180 / std::numbers::pi;
    constexpr double full_turn = 360;
    constexpr double quarter_turn = 90;
    const double ahead = rounded_in(map.translation.y, size, digits);
    const double right = rounded_in(map.translation.x, size, digits);
    const double turn = rounded_in((step.turn + step.spin) * degrees, full_turn, digits);
    const double scale = rounded_factor(step.scale, digits);
    ModuleTemplates string;
    if (ahead != 0) string.push_back(command("f", ahead));
    if (right != 0) {
        append_turn(string, -quarter_turn);
        string.push_back(command("f", right));
    }
    if (scale != 1) string.push_back(command("*", scale));
    append_turn(string, rounded_in(std::remainder(turn + (right != 0 ? quarter_turn : 0), full_turn), full_turn, digits));
    if (step.mirrored) string.push_back({"|", {}, {}});
    return string;
}

}  // namespace rinceau
