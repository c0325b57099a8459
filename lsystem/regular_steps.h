#pragma once
// Steps of rules that are nearly regular become regular. Internal to the folder.

#include "lsystem/edit_result.h"
#include "lsystem/grammar.h"

namespace rinceau {

/// A turn that nearly closes a ring closes it; a row that nearly keeps its heading, or nearly goes straight on or straight
/// aside, does so; steps of rules used in one string, and of the branches of one rule, that nearly agree take the value that
/// is said with the fewest digits. `tolerance` as in symmetrize.h.
EditResult with_regular_steps(const Grammar& grammar, double tolerance);

}  // namespace rinceau
