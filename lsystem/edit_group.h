#pragma once
// Modules that stand side by side become a rule of their own.

#include <string>

#include "lsystem/edit_result.h"
#include "lsystem/expression_place.h"
#include "lsystem/grammar.h"

namespace rinceau {

struct GroupOptions {
    StringPlace string;
    int first = 0;     ///< positions of the modules ..
    int last = 0;      ///< .. the last one included
    std::string name;  ///< of the new symbol; with a number behind it if it is taken
};

/// The modules become the successor of a new rule, whose symbol stands in their place, with the parameters that they use.
/// The picture stays the same, but for what is drawn at random, which is drawn anew; exceptions move along. Throws
/// InputError for positions outside the string, for half a pair of brackets, modules that draw nothing, a rule that would
/// continue another one, homomorphisms and contexts, and as moved_exceptions().
EditResult group_modules(const Grammar& grammar, const GroupOptions& options);

}  // namespace rinceau
