#pragma once
// Colour commands as styles by number, for formats that know styles only. Internal to the folder.

#include "lsystem/grammar.h"

namespace rinceau {

/// A flat grammar (lsystem/flat_grammar.h) that draws the same without fill(..) and stroke(..): what they repaint is drawn
/// in styles that are added.
Grammar colors_as_styles(Grammar flat);

/// Do the axiom or the productions have colour commands?
bool has_color_commands(const Grammar& grammar);

}  // namespace rinceau
