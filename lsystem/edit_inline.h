#pragma once
// A rule put in the place of its symbol.

#include <string>
#include <vector>

#include "lsystem/edit_result.h"
#include "lsystem/grammar.h"

namespace rinceau {

/// Every module of the symbol becomes the successor of its rule, with its arguments, and the rule goes away. The picture
/// stays the same, but for what is drawn at random, which is drawn anew; exceptions move along. Throws InputError for a
/// symbol that has not exactly one rule which always rewrites it, holds itself, is a context or stands in a homomorphism,
/// for arguments that are drawn at random, for names that mean something else where the symbol stands, and as
/// moved_exceptions().
EditResult inline_rule(const Grammar& grammar, const std::string& symbol);

/// The symbols that have such a rule and a use, in the order of the productions.
std::vector<std::string> symbols_to_inline(const Grammar& grammar);

}  // namespace rinceau
