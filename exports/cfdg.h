#pragma once
// Context Free's language (cfdg 3): shapes with parameters, ordered adjustments, paths.

#include "exports/export.h"

namespace rinceau {

/// The rules as shapes where that is possible, else every part of the picture as a shape with numbers. What is drawn by
/// chance is frozen at the seed, or written as such with options.live_random. Heights (z) keep the paint order.
Export to_cfdg(const Grammar& grammar, const ExportOptions& options = {});

}  // namespace rinceau
