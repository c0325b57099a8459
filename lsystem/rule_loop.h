#pragma once
// Rules that repeat themselves, P(m) : m > 0 -> .. P(m-1): how often, and by which turn each time. Internal to the folder.

#include <optional>
#include <vector>

#include "lsystem/approach.h"
#include "lsystem/constant_values.h"
#include "lsystem/expression_place.h"
#include "lsystem/grammar.h"

namespace rinceau {

/// written = slope * count + offset, where `count` is the number of times that the production applies.
struct CountLaw {
    double slope = 1;
    double offset = 0;
};

/// A production whose own symbol stands in its successor with one parameter counted down to a limit, or up to one.
struct RuleLoop {
    int production = 0;
    int parameter = 0;                    ///< the one that counts
    bool up = false;                      ///< counts up: the count is written in the condition, `limit`
    CountLaw law;                         ///< of what the uses write, or for `up` of the limit for uses that start at 0
    double step = 1;                      ///< of the parameter
    ExpressionPlace limit;                ///< in the condition
    std::vector<Approach> continuations;  ///< approaches to its own symbol: one, or several for a tree
    bool has_drawn_end = false;           ///< another production of the symbol, or a drawing, takes over at the end
};

/// At most one for a production: of the first parameter that counts.
std::vector<RuleLoop> rule_loops(const Grammar& grammar);

/// A module that starts a loop from outside.
struct LoopUse {
    StringPlace string;
    int position = 0;
    std::optional<double> count;  ///< if it does not depend on parameters
    ExpressionPlace written;      ///< where the count is written: the argument, or the limit
    CountLaw law;
};

/// In the order of strings_of().
std::vector<LoopUse> uses_of(const Grammar& grammar, const RuleLoop& loop);

/// The constants that a string or production sees: parameters hide them.
Scope constants_in(const Grammar& grammar, const Scope& constants, const StringPlace& string);

}  // namespace rinceau
