#pragma once
// The regular grammar behind an irregular one (docs/editing.md).

#include "lsystem/edit_result.h"
#include "lsystem/grammar.h"

namespace rinceau {

struct SymmetrizeOptions {
    bool all_exceptions = false;  ///< holes and stand-ins, too
};

/// Takes away noise; exceptions that only move, turn or scale what stands at their address (what they say of style, layer or
/// hand is kept); and what is nearly regular in the steps of rules: a turn that nearly closes a ring closes it, steps of
/// rules that stand side by side and nearly agree agree, rows that nearly keep their heading or direction keep it. `changes`
/// says all of it.
EditResult symmetrize(const Grammar& grammar, const SymmetrizeOptions& options = {});

}  // namespace rinceau
