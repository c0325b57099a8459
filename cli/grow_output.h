#pragma once
// What has grown on a surface, as files.

#include "cli/grow_options.h"

namespace rinceau {

/// By the output's ending. Returns the faces of all copies.
long write_grown(const SurfacePattern& pattern, const SurfaceMesh& surface, const GrowVerbOptions& options);

}  // namespace rinceau
