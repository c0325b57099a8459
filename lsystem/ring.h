#pragma once
// Rules that come back to where they began: their count times their turn is a whole number of full turns. Internal to the
// folder.

#include <vector>

#include "lsystem/rule_loop.h"

namespace rinceau {

/// One use of a loop that closes.
struct Ring {
    RuleLoop loop;
    LoopUse use;
    double elements = 0;    ///< the count, and one more if something is drawn at the end
    double turn = 0;        ///< degrees from one to the next, to the left
    double full_turns = 0;  ///< elements * |turn| / 360
};

/// Degrees to the left from one element to the next, for this use; nothing if it changes along the way or is not known.
std::optional<double> turn_of(const Grammar& grammar, const RuleLoop& loop, const LoopUse& use);

double elements_of(const RuleLoop& loop, const LoopUse& use);

/// In the order of the loops and their uses. What goes around more than once counts only if nothing in the rule changes
/// from one element to the next: the golden angle of a flower head is no ring, even with 144 seeds.
std::vector<Ring> closed_rings(const Grammar& grammar);

/// Is it a ring of so many elements?
bool closes(double elements, double turn);

}  // namespace rinceau
