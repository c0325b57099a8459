#pragma once
// The functions and constants of expressions, as data. Internal to the folder.

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace rinceau {

/// One function. `at_most` arguments; `evaluate` gets between at_least and at_most numbers. It is nullptr for a function
/// whose result is drawn at random.
struct ExpressionFunction {
    std::string_view name;
    int at_least;
    int at_most;
    double (*evaluate)(std::span<const double> arguments);
    bool only_with_queries = false;  ///< of shape grammars (ExpressionForm)
};

/// rand takes no numbers or two.
constexpr bool takes(const ExpressionFunction& function, int count) {
    const bool drawn_without_limits = function.at_least == 0 && function.evaluate == nullptr;
    if (drawn_without_limits) return count == 0 || count == function.at_most;
    return count >= function.at_least && count <= function.at_most;
}

/// Most arguments that any function takes.
constexpr int max_function_arguments = 64;

/// nullptr if there is no function of that name.
const ExpressionFunction* find_expression_function(std::string_view name);

std::vector<std::string_view> expression_function_names(bool with_queries = false);

/// pi, e.
std::optional<double> named_constant(std::string_view name);

/// Cosine and sine of an angle in degrees; exact at multiples of 90 degrees, so that quarter turns keep round numbers round.
double cosine_of_degrees(double angle);
double sine_of_degrees(double angle);

}  // namespace rinceau
