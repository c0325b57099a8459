#pragma once
// Grammars for pen plotters: HP-GL. The worked example of docs/how_to/export.md.

#include "exports/export.h"

namespace rinceau {

/// The picture as pens draw it: outlines as polylines within a plotter's unit of 1/40 mm, counted from the low left corner
/// of the canvas, a pen for each colour (at most 8), what is drawn in one pen together. Lines are as wide as the pens. A
/// fill is its outline, dashes are whole lines, fragments of SVG are left out: notes say so. Throws as derive(), and
/// InputError if nothing would be drawn.
Export to_hpgl(const Grammar& grammar, const ExportOptions& options = {});

}  // namespace rinceau
