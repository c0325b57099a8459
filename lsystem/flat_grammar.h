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

/// A grammar that draws the scene: each element is a terminal of its own, E1, E2, .., where it stands, and the axiom names
/// them in paint order. In time proportional to the scene.
Grammar flat_grammar(const Scene& scene);

}  // namespace rinceau
