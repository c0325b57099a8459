#pragma once
// cpfg (Virtual Laboratory, algorithmicbotany.org): the grammar as a .l file with its view (.v) and colour map (.map).

#include "exports/export.h"

namespace rinceau {

/// Rules and all. Symbols are single characters; if there are more of them than characters, the last share one and are told
/// apart by a first parameter. Curves are polylines within flatness_share of the shape's size. cpfg keeps parameters as
/// single-precision numbers.
Export to_cpfg(const Grammar& grammar, const ExportOptions& options = {});

}  // namespace rinceau
