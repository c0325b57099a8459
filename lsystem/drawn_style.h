#pragma once
// In which style a placement is drawn, and which colour stands for a number.

#include "lsystem/grammar.h"
#include "lsystem/interpret.h"

namespace rinceau {

/// The number of the style that a placement is drawn in: the one in force, or the terminal's own.
int drawn_style_number(const Grammar& grammar, const Placement& placement);

/// The style with its solid paints in the colours of the repaint.
Style repainted(Style style, const Repaint& repaint);

/// Colours that are easy to tell apart, without end: hues by the golden angle in OKLab, lightness in turn.
Color distinct_color(int index);

/// The style with everything that it paints in one colour; opacities stay.
Style recolored(Style style, Color color);

}  // namespace rinceau
