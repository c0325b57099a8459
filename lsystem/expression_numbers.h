#pragma once
// The numbers within one expression: the whole if it has a value, a + b*m as a and b, else every number that is written.
// Internal to the folder.

#include <string>
#include <vector>

#include "lsystem/expression.h"
#include "lsystem/program.h"

namespace rinceau {

/// The nodes [first, last) of the postfix form are worth `value` times `slope`.
struct NumberInExpression {
    enum class Part : unsigned char { value, change, noise, literal };
    Part part = Part::value;
    int first = 0;
    int last = 0;
    double value = 0;
    double slope = 1;
    std::string parameter;  ///< Part::change: the b of b*m is for one more of m
    int ordinal = 1;        ///< Part::literal
    int negative_at = -1;   ///< Part::noise: node that is the negative of the value; -1 = none
};

std::vector<NumberInExpression> numbers_in(const Expression& expression, const Scope& constants);

}  // namespace rinceau
