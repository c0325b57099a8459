#pragma once
// A row that is bent to a ring, and a ring that is straightened to a row.

#include <string>
#include <vector>

#include "lsystem/edit_result.h"
#include "lsystem/grammar.h"

namespace rinceau {

struct RingOptions {
    double radius = 0;  ///< 0 = neighbours stay as far apart as they are
};

/// The rule that repeats itself, P(m) : m > 0 -> [A] f(20) P(m-1), becomes a ring of as many elements: [f(r) A] +(360/n)
/// P(m-1). Its centre is the middle of the row, elements head outwards, and what follows finds the turtle where the row
/// began. Addresses keep their modules. Throws InputError for a symbol without such a rule, for several branches, uses with
/// different counts, a count or (without a radius) a step that is not a number, and elements behind the own symbol.
EditResult make_ring(const Grammar& grammar, const std::string& symbol, const RingOptions& options = {});

struct RowOptions {
    double distance = 0;  ///< from one to the next; 0 = as in the ring
};

/// The ring becomes a row from left to right about its centre. Throws in the same way, and for a rule that does not turn.
EditResult make_row(const Grammar& grammar, const std::string& symbol, const RowOptions& options = {});

/// The symbols with a rule that repeats itself once, in the order of the productions.
std::vector<std::string> symbols_of_rows(const Grammar& grammar);

}  // namespace rinceau
