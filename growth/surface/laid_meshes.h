#pragma once
// Laid shapes as meshes that lie just above the surface, one above the other in paint order.

#include <vector>

#include "growth/surface/laid_shape.h"

namespace rinceau {

struct LaidMeshOptions {
    double lift = 1e-5;       ///< of the lowest shape above the surface, of its diagonal
    double rank_lift = 2e-5;  ///< more for each shape that lies below, of the diagonal
    double most_lift = 2e-3;  ///< for all of them together: with very many ranks the steps are smaller
    double height = 0;        ///< of walls, surface length; 0 = flat
};

/// Shape i lies below shape i of `ranks`: rank 0 is the lowest. One mesh for each colour and layer of the drawing (`layers`
/// by shape), in order of layers and then of first use; normals are those of the surface.
std::vector<NamedMesh> laid_meshes(const SurfaceMesh& surface, const std::vector<LaidShape>& shapes,
                                   const std::vector<int>& ranks, const std::vector<int>& layers,
                                   const LaidMeshOptions& options = {});

/// Rank of each shape: one more than the highest rank of the shapes painted before it that it covers. `order` are the shapes
/// in paint order, `covers` those with area in common.
std::vector<int> paint_ranks(const std::vector<int>& order, const std::vector<std::vector<int>>& covers);

}  // namespace rinceau
