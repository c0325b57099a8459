#pragma once
// The picture of a grammar without its rules: for programs that cannot hold them, and to freeze what is drawn by chance.

#include "lsystem/derive.h"
#include "lsystem/grammar.h"

namespace rinceau {

/// A grammar that draws the same picture without productions, constants, exceptions and layers: its axiom has one bracket
/// per placement, in paint order, each from the origin: [+(a) f(d) *(s) +(b) | ;(n) A]. Equal to rounding: a placement's
/// numbers agree to some 1e-15 of their size. Title, canvas, comments, styles and terminals are kept.
/// Throws as interpret().
Grammar flat_grammar(const Grammar& grammar, const DeriveOptions& options = {});

}  // namespace rinceau
