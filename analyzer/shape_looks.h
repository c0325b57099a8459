#pragma once
// The second reading of a drawing: what is equal but for its style is one look (docs/analysis.md, 2 and 7.1). Rules found in
// it speak of shapes; colours come back as arguments (colouring.h).

#include <optional>

#include "analyzer/instancing.h"

namespace rinceau {

/// Merges looks of one shape whose symmetries agree and that one outline can draw in all their styles: no copy's outline moves
/// by more than 1e-5 of the diagonal (scene length). Poses stay as they are; instances keep their styles as tints. Nothing
/// if no two looks can be merged.
std::optional<Instancing> merged_by_shape(const Instancing& instancing, double diagonal);

}  // namespace rinceau
