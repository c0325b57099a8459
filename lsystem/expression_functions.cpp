#include "lsystem/expression_functions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "geometry/angle.h"
#include "lsystem/lattice_noise.h"

namespace rinceau {

double sine_of_degrees(double angle) {
    const double turned = std::remainder(angle, 360.0);
    if (turned == 0 || std::abs(turned) == 180) return 0;
    if (std::abs(turned) == 90) return turned > 0 ? 1 : -1;
    return std::sin(radians(turned));
}

double cosine_of_degrees(double angle) {
    const double turned = std::abs(std::remainder(angle, 360.0));
    if (turned == 90) return 0;
    if (turned == 180) return -1;
    return std::cos(radians(turned));
}

namespace {

using Numbers = std::span<const double>;

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

double sign_of(double value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

double choice(double condition, double yes, double no) {
    if (std::isnan(condition)) return undefined;
    return condition != 0 ? yes : no;
}

double clamped(double value, double low, double high) {
    return low <= high ? std::min(std::max(value, low), high) : undefined;
}

constexpr std::array functions{
    ExpressionFunction{"sin", 1, 1, [](Numbers n) { return sine_of_degrees(n[0]); }},
    ExpressionFunction{"cos", 1, 1, [](Numbers n) { return cosine_of_degrees(n[0]); }},
    ExpressionFunction{"tan", 1, 1, [](Numbers n) { return sine_of_degrees(n[0]) / cosine_of_degrees(n[0]); }},
    ExpressionFunction{"asin", 1, 1, [](Numbers n) { return degrees(std::asin(n[0])); }},
    ExpressionFunction{"acos", 1, 1, [](Numbers n) { return degrees(std::acos(n[0])); }},
    ExpressionFunction{"atan", 1, 1, [](Numbers n) { return degrees(std::atan(n[0])); }},
    ExpressionFunction{"atan2", 2, 2, [](Numbers n) { return degrees(std::atan2(n[0], n[1])); }},
    ExpressionFunction{"sqrt", 1, 1, [](Numbers n) { return std::sqrt(n[0]); }},
    ExpressionFunction{"exp", 1, 1, [](Numbers n) { return std::exp(n[0]); }},
    ExpressionFunction{"log", 1, 1, [](Numbers n) { return std::log(n[0]); }},
    ExpressionFunction{"abs", 1, 1, [](Numbers n) { return std::abs(n[0]); }},
    ExpressionFunction{"floor", 1, 1, [](Numbers n) { return std::floor(n[0]); }},
    ExpressionFunction{"ceil", 1, 1, [](Numbers n) { return std::ceil(n[0]); }},
    ExpressionFunction{"round", 1, 1, [](Numbers n) { return std::round(n[0]); }},
    ExpressionFunction{"sign", 1, 1, [](Numbers n) { return sign_of(n[0]); }},
    ExpressionFunction{"min", 1, max_function_arguments, [](Numbers n) { return *std::min_element(n.begin(), n.end()); }},
    ExpressionFunction{"max", 1, max_function_arguments, [](Numbers n) { return *std::max_element(n.begin(), n.end()); }},
    ExpressionFunction{"pow", 2, 2, [](Numbers n) { return std::pow(n[0], n[1]); }},
    ExpressionFunction{"if", 3, 3, [](Numbers n) { return choice(n[0], n[1], n[2]); }},
    ExpressionFunction{"hypot", 2, 2, [](Numbers n) { return std::hypot(n[0], n[1]); }},
    ExpressionFunction{"log10", 1, 1, [](Numbers n) { return std::log10(n[0]); }},
    ExpressionFunction{"trunc", 1, 1, [](Numbers n) { return std::trunc(n[0]); }},
    ExpressionFunction{"clamp", 3, 3, [](Numbers n) { return clamped(n[0], n[1], n[2]); }},
    ExpressionFunction{"uniform", 2, 2, nullptr},
    ExpressionFunction{"normal", 2, 2, nullptr},
    ExpressionFunction{"rand", 0, 2, nullptr, true},
    ExpressionFunction{"noise", 1, 3, [](Numbers n) { return lattice_noise(n); }, true},
};

}  // namespace

const ExpressionFunction* find_expression_function(std::string_view name) {
    const auto* found = std::ranges::find(functions, name, &ExpressionFunction::name);
    return found == functions.end() ? nullptr : found;
}

std::vector<std::string_view> expression_function_names(bool with_queries) {
    std::vector<std::string_view> names;
    for (const ExpressionFunction& function : functions)
        if (with_queries || !function.only_with_queries) names.push_back(function.name);
    return names;
}

std::optional<double> named_constant(std::string_view name) {
    if (name == "pi") return pi;
    if (name == "e") return std::numbers::e;
    return std::nullopt;
}

}  // namespace rinceau
