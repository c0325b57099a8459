#pragma once
// SVG with a definition per terminal and a <use> per placement, which Inkscape keeps as live clones.

#include "exports/export.h"

namespace rinceau {

Export to_svg_clones(const Grammar& grammar, const ExportOptions& options = {});

}  // namespace rinceau
