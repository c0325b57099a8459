#pragma once
// The regular grammar behind an irregular one (docs/editing.md).

#include "lsystem/edit_result.h"
#include "lsystem/grammar.h"

namespace rinceau {

struct SymmetrizeOptions {
    bool all_exceptions = false;  ///< holes and stand-ins, too
    /// How near is nearly: times the limits of docs/editing.md, which say what a hand misses by. 0 = what is exactly
    /// regular.
    double tolerance = 1;
};

/// Takes away noise; exceptions that only move, turn or scale what stands at their address (what they say of style, layer or
/// hand is kept); and what is nearly regular in the steps of rules: a turn that nearly closes a ring closes it, steps of
/// rules that stand side by side and nearly agree agree, rows that nearly keep their heading or direction keep it. `changes`
/// says all of it. Throws InputError for a tolerance below 0.
EditResult symmetrize(const Grammar& grammar, const SymmetrizeOptions& options = {});

}  // namespace rinceau
