#pragma once
// Exceptions whose addresses are those of another grammar with the same picture. Internal to the folder.

#include <string>
#include <vector>

#include "lsystem/grammar.h"

namespace rinceau {

/// The exceptions of `before` for `after`, whose other parts derive the same terminals in the same order, but that modules
/// of `symbol` are a level of their own in one of both only. Throws InputError for exceptions below others, at modules that
/// draw nothing and at modules of `symbol`; and as interpret().
std::vector<Exception> moved_exceptions(const Grammar& before, const Grammar& after, const std::string& symbol);

}  // namespace rinceau
