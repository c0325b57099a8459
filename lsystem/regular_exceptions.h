#pragma once
// Exceptions less what only moves, turns or scales. Internal to the folder.

#include "lsystem/edit_result.h"
#include "lsystem/grammar.h"

namespace rinceau {

/// Exceptions at addresses where nothing stands stay. `all`: none is left.
EditResult with_regular_exceptions(const Grammar& grammar, bool all);

}  // namespace rinceau
