#pragma once
// SVG with live clones, for Inkscape: whatever a rule makes more than once is there once, as a thing to select and edit, and
// every other one is a clone of it.

#include "exports/export.h"

namespace rinceau {

/// A group per rule that was applied, with the symbol as its label, nested as the rules are; the first of equal groups and
/// shapes is the original, the others are <use>. Layers (z) are Inkscape's layers, each with groups of its own.
/// Places keep 1e-11 of the picture or better.
Export to_svg_clones(const Grammar& grammar, const ExportOptions& options = {});

}  // namespace rinceau
