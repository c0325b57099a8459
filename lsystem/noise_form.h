#pragma once
// The forms in which noise is written into an expression, and found there again: a + normal(0, s) for angles,
// d*(1 + normal(0, s)) for distances, k*exp(normal(0, s)) for scales. Internal to the folder.

#include <optional>

#include "lsystem/expression.h"

namespace rinceau {

enum class NoiseKind : unsigned char { angle, distance, scale };

struct NoiseInExpression {
    NoiseKind kind = NoiseKind::angle;
    int base_size = 0;     ///< the first nodes of the postfix form are the expression without noise ..
    int deviation_at = 0;  ///< .. and here stands the standard deviation, a number
    double deviation = 0;
};

/// Nothing if the expression does not end in one of these forms.
std::optional<NoiseInExpression> find_noise(const Expression& expression);

/// The expression with this noise put on it; `deviation` > 0. find_noise() finds it.
Expression with_noise(const Expression& expression, NoiseKind kind, double deviation);

/// The expression without noise, exactly as it was before.
Expression without_noise(const Expression& expression);

/// Does it draw random numbers?
bool is_random(const Expression& expression);

}  // namespace rinceau
