#pragma once
// L-Py (openalea): the grammar as a .lpy file, rules and all.

#include "exports/export.h"

namespace rinceau {

/// Outlines are PlantGL curves (exact), fills are turtle polygons (curves flattened to flatness_share of the shape's size),
/// strokes are lines of whole pixels. L-Py's turtle heads +Z in the plane Y-Z: our (x, y) is its (y, z).
Export to_lpy(const Grammar& grammar, const ExportOptions& options = {});

}  // namespace rinceau
