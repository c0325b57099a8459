#pragma once
// After a number was set: rings that were closed are closed again. Internal to the folder.

#include "lsystem/edit_result.h"
#include "lsystem/grammar.h"

namespace rinceau {

/// `after` differs from `before` in numbers only. If the count of a ring is another one, its turn follows; if its turn is,
/// its count does. Throws InputError if no whole count closes it.
EditResult keep_rings_closed(const Grammar& before, const Grammar& after);

}  // namespace rinceau
