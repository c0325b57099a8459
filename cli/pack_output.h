#pragma once
// What `rinceau pack` writes.

#include <string>
#include <vector>

#include "cli/pack_options.h"
#include "cli/pack_shapes.h"
#include "growth/aggregate/pack_domain.h"

namespace rinceau {

/// The aggregate in the format that options.output says, and its relief where one is asked for. Throws OutputError, and
/// LimitError for pictures that are too large.
void write_pack(const PackShapes& shapes, const std::vector<PlacedRegion>& placed, const PackDomain& domain,
                const PackVerbOptions& options, const Progress& progress);

}  // namespace rinceau
