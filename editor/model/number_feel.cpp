#include "editor/model/number_feel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace rinceau {

namespace {

/// 1, 0.1, 0.01, ..: the largest one that is at most a tenth of the value.
double tenth_power(double value) { return std::pow(10, std::floor(std::log10(value)) - 1); }

double speed_of(const GrammarNumber& number, double start) {
    constexpr double whole_speed = 0.1;  // ten pixels for one more
    constexpr double angle_speed = 0.25;
    constexpr double share_speed = 0.005;
    constexpr double of_size = 0.005;  // 200 pixels for as much again
    constexpr double least_size = 1;
    constexpr double least_scale = 0.1;
    if (number.whole || number.kind == NumberKind::seed) return whole_speed;
    if (number.kind == NumberKind::angle) return angle_speed;
    if (number.kind == NumberKind::share) return share_speed;
    const double least = number.kind == NumberKind::scale ? least_scale : least_size;
    return of_size * std::max(std::abs(start), least);
}

}  // namespace

NumberFeel number_feel(const GrammarNumber& number, double start) {
    NumberFeel feel{.speed = speed_of(number, start), .step = 1, .low = number.low, .high = number.high};
    constexpr double angle_step = 0.5;
    constexpr double share_step = 0.01;
    constexpr double least_scale = 0.001;  // scales stay above 0
    if (number.whole) return feel;
    if (number.kind == NumberKind::angle) {
        feel.step = angle_step;
    } else if (number.kind == NumberKind::share) {
        feel.step = share_step;
    } else {
        feel.step = 10 * tenth_power(feel.speed);
    }
    if (number.kind == NumberKind::scale) feel.low = std::max(feel.low, least_scale);
    return feel;
}

double felt_value(const NumberFeel& feel, double value) {
    const double stepped = std::round(value / feel.step) * feel.step;
    constexpr double digits = 1e12;  // 0.1 + 0.2 is 0.3
    const double clean = std::abs(stepped) < 1 / feel.step ? std::round(stepped * digits) / digits : stepped;
    return std::clamp(clean, feel.low, feel.high);
}

double slider_end(double start) {
    constexpr double least = 12;
    constexpr double room = 2;
    return std::max(least, std::ceil(room * start));
}

std::string number_label(const GrammarNumber& number, double value) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), number.whole ? "%.15g" : "%.6g", value == 0 ? 0 : value);
    std::string label = text.data();
    if (number.unit == "degrees") return label + "\u00b0";
    if (number.kind == NumberKind::scale && number.unit.empty()) return "\u00d7" + label;
    return label;
}

}  // namespace rinceau
