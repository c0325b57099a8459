#pragma once
// Productions that make themselves again without an end. Internal to the folder.

#include <set>
#include <string>
#include <vector>

#include "lsystem/grammar.h"
#include "lsystem/mistakes.h"
#include "lsystem/production_order.h"

namespace rinceau {

/// Circles of productions of one kind that never end, whatever the numbers are; each is named once. `order` is of the same
/// grammar; `unsure` are symbols whose productions may be other ones than they look.
std::vector<Warning> check_ends(const Grammar& grammar, const ProductionOrder& order, const std::set<std::string>& unsure);

}  // namespace rinceau
