#pragma once
// A picture of who is whose neighbour in an arrangement.

#include <string>
#include <utility>
#include <vector>

#include "geometry/box.h"
#include "scene/painted_region.h"

namespace rinceau {

struct PicturedNode {
    Point position;
    Region outline;  ///< in the scene; may be empty
};

/// Outlines in grey, edges above them, dots for elements.
std::string edges_svg(const std::vector<PicturedNode>& nodes, const std::vector<std::pair<int, int>>& edges,
                      const Box& canvas);

}  // namespace rinceau
