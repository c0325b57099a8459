#pragma once
// A JavaScript module for the package `lindenmayer` of npm: productions as functions, and a turtle as its `finals`.

#include "exports/export.h"

namespace rinceau {

/// The module exports `lsystem`, `terminals`, `styles`, `canvas` and placements(), which gives what is drawn in paint order,
/// with SVG's matrices; run by node it prints them as JSON. Contexts and draws by chance are frozen: every placement by
/// itself.
Export to_lindenmayer(const Grammar& grammar, const ExportOptions& options = {});

}  // namespace rinceau
