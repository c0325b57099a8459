#pragma once
// Rules of one kind, for programs that do not tell rewriting, decomposition and homomorphism apart.

#include "lsystem/grammar.h"

namespace rinceau {

/// A grammar whose productions all rewrite and that draws the same when it is derived until nothing is left to rewrite.
/// - A decomposition stands before the symbol's other productions, a homomorphism behind them.
/// - What a homomorphism makes is not rewritten: a symbol with productions of another kind gets a second name there.
/// Needs a grammar without contexts, exceptions and limit of depth (unfolded_exceptions.h).
Grammar plain_rules(const Grammar& grammar);

/// Does anything in it depend on chance: a weight, uniform() or normal()?
bool is_stochastic(const Grammar& grammar);

/// Has a production a context?
bool is_context_sensitive(const Grammar& grammar);

}  // namespace rinceau
