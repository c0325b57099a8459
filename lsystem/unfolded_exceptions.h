#pragma once
// Exceptions and a limit of depth as plain rules, for programs that know neither.

#include "lsystem/derive.h"
#include "lsystem/grammar.h"

namespace rinceau {

/// A grammar without exceptions whose whole derivation (depth -1) is that of `grammar` with options.depth.
/// - Exceptions: every module in whose expansion an exception applies is expanded into the axiom, with numbers for
///   arguments; all other modules stay, so that the structure is kept where nothing is excepted. Beside homomorphisms
///   it is the flat grammar (flat_grammar.h): equal in what is drawn.
/// - A depth: symbols with productions that take a step get a last parameter, the steps that are left.
/// A grammar with neither is returned as it is. What is drawn by chance may be drawn differently: freeze it before
/// (flat_grammar.h). Throws as derive().
Grammar unfolded_exceptions(const Grammar& grammar, const DeriveOptions& options = {});

}  // namespace rinceau
