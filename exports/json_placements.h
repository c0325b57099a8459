#pragma once
// What a grammar draws, as a list for programs: JSON with the terminals and where each is placed, in paint order.

#include "exports/export.h"

namespace rinceau {

/// {"format": "rinceau-placements", "version": 1,
///  "canvas": [x, y, width, height] or null,
///  "styles": [{"number", "fill", "stroke", "stroke_width", "fixed", "stroke_first", "fill_rule"}], where a paint is "none",
///  "#rrggbb" or "gradient", "terminals": [{"symbol", "path", "verbatim"}], "placements": [{"terminal": index, "style":
///  number, "layer": k, "order": place in the derivation, "matrix": [a, b, c, d, e, f]}]}, one a line.
/// A placement that colour commands repaint has "fill" or "stroke", too.
/// Everything as SVG has it, y down: `matrix` takes a point of the terminal's path to the picture. Numbers are exact.
Export to_placements(const Grammar& grammar, const ExportOptions& options = {});

}  // namespace rinceau
