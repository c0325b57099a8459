#pragma once
// Mistakes in productions and in how they work together. Internal to the folder.

#include <set>
#include <string>
#include <vector>

#include "lsystem/check_strings.h"
#include "lsystem/grammar.h"
#include "lsystem/production_order.h"

namespace rinceau {

/// In every production: its successor, condition, weight and context. In their order: productions that never apply,
/// weights behind a production without one, weights that are all 0. `constants` has those whose value is not
/// known as parameters; `order` is of the same grammar; `unsure` are symbols
/// whose productions may be other ones than they look.
std::vector<Warning> check_productions(const Grammar& grammar, const KnownNames& names, const Scope& constants,
                                       const ProductionOrder& order, const std::set<std::string>& unsure);

}  // namespace rinceau
