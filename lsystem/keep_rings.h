#pragma once
// After a number was set: rings that were closed are closed again. Internal to the folder.

#include "lsystem/edit_result.h"
#include "lsystem/grammar.h"
#include "lsystem/ring.h"

namespace rinceau {

struct KeepRingsOptions {
    bool nearest_count = false;  ///< a turn that no whole count closes becomes the nearest one that one does; else it throws
};

/// `after` differs from `before` in numbers only. If the count of a ring is another one, its turn follows; if its turn is,
/// its count does. Throws InputError if no whole count closes it.
EditResult keep_rings_closed(const Grammar& before, const Grammar& after, const KeepRingsOptions& options = {});

/// Gives these rings the turns that close them, as often around as they say.
EditResult close_rings(const Grammar& grammar, std::vector<Ring> rings);

}  // namespace rinceau
