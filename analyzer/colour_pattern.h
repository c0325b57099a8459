#pragma once
// One place in a rule where a colour is chosen: the shortest expression that says which, for all that the rule draws
// (docs/analysis.md, 7.1).

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "lsystem/expression.h"

namespace rinceau {

/// A style number, or an argument that leads to one.
using Tint = std::int64_t;

/// What stands in the place once.
struct TintUse {
    int owner = 0;  ///< copy of the rule, from 0
    int m = 0;      ///< repetition, counted down to 1; 0 where the rule does not repeat
    Tint tint = 0;
};

/// Parameters that the rule has already, with their values by owner.
struct TintParameter {
    std::string name;
    std::vector<Tint> values;
};

struct TintColumn {
    std::vector<TintUse> uses;
    int owners = 1;
    std::string counter;      ///< name of m; empty = the rule does not repeat
    std::vector<int> counts;  ///< repetitions by owner, if it does
    Tint styles = 0;          ///< > 0: these are style numbers, and whatever stands there, 1 .. styles must come out
};

struct TintPattern {
    Expression expression;         ///< in the counter, known parameters and at most one new one
    std::vector<Tint> parameter;   ///< values of the new one by owner; empty = it needs none
    std::vector<int> departures;   ///< indices of uses that the expression misses
    std::vector<Tint> missing;     ///< by departure: what would have to be added
    double bits = 0;
};

/// `new_name`: of a parameter, should one be needed; empty = none is to be had. `exception_bits`: price of one departure.
TintPattern shortest_pattern(const TintColumn& column, std::span<const TintParameter> known, const std::string& new_name,
                             double exception_bits);

/// Price of an expression of tints: whole numbers by their length, 2 bits for each name and operator.
double tint_bits(const Expression& expression);

}  // namespace rinceau
