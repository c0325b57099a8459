#pragma once
// Numbers that edits leave alone.

#include <set>
#include <string>

#include "lsystem/edit_result.h"
#include "lsystem/grammar.h"

namespace rinceau {

/// The edit of `before` with the locked numbers (by their names of numbers.h) as they were, without noise that the edit put
/// on them; rings stay closed. `changes` says which ones were put back. Names that one of the two grammars lacks are of no
/// account. Throws InputError, which names a locked number, if nothing is left of the edit, or if a number cannot be put
/// back. Guarantee: every locked number that both grammars have has its old value.
EditResult keep_locked(const Grammar& before, EditResult edit, const std::set<std::string>& locked);

}  // namespace rinceau
