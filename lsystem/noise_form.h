#pragma once
// The forms in which noise is written into a grammar, and found there again. In an expression: a + normal(0, s) for angles,
// d*(1 + normal(0, s)) for distances, k*exp(normal(0, s)) for scales. As a command of its own, where nothing is turned or
// scaled yet: +(normal(0, s)), *(exp(normal(0, s))), and the other way round, -(normal(0, s)), *(1/exp(normal(0, s))), where
// brackets came with it. uniform(-s, s) may stand for normal(0, s) everywhere. Internal to the folder.

#include <optional>

#include "lsystem/expression.h"
#include "lsystem/grammar.h"
#include "lsystem/noise.h"

namespace rinceau {

enum class NoiseKind : unsigned char { angle, distance, scale };

struct NoiseInExpression {
    NoiseKind kind = NoiseKind::angle;
    Noise noise;
    int base_size = 0;     ///< the first nodes of the postfix form are the expression without noise ..
    int spread_at = 0;     ///< .. and here stands the spread, a number
    int negative_at = -1;  ///< of uniform(-s, s): and here its negative
};

/// Nothing if the expression does not end in one of these forms.
std::optional<NoiseInExpression> find_noise(const Expression& expression);

/// The expression with this noise put on it, whose spread is > 0. find_noise() finds it.
Expression with_noise(const Expression& expression, NoiseKind kind, const Noise& noise);

/// The expression without noise, exactly as it was before.
Expression without_noise(const Expression& expression);

/// Does it draw random numbers?
bool is_random(const Expression& expression);

/// A command that is noise and nothing else.
struct NoiseCommand {
    NoiseKind kind = NoiseKind::angle;  ///< angle or scale
    Noise noise;
    bool bracketed = false;  ///< brackets about it and the next symbol came with it
};

struct FoundNoiseCommand {
    NoiseCommand command;
    int spread_at = 0;     ///< in the argument's postfix form
    int negative_at = -1;  ///< of uniform(-s, s): and here its negative
};

ModuleTemplate noise_command(const NoiseCommand& noise);
std::optional<FoundNoiseCommand> find_noise_command(const ModuleTemplate& module);

}  // namespace rinceau
