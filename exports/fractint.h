#pragma once
// Fractint and Iterated Dynamics: an entry of a .l file, with a colour map.

#include "exports/export.h"

namespace rinceau {

/// Fractint has neither numbers nor conditions in its rules: the derived string is written, and what comes again in it gets
/// a symbol, so that a row of 2^k is k symbols. It draws lines only: a fill is its outline, widths are left out, curves are
/// polylines within flatness_share of the shape's size. Throws also InputError if the string is too long.
Export to_fractint(const Grammar& grammar, const ExportOptions& options = {});

}  // namespace rinceau
