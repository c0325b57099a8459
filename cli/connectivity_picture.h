#pragma once
// Pictures of who is whose neighbour.

#include <string>
#include <utility>
#include <vector>

#include "growth/arrangement/exemplar.h"

namespace rinceau {

struct ConnectivityNode {
    Point position;
    Region outline;    ///< in the scene; may be empty
    std::string name;  ///< written beside it; empty = nothing
    bool marked = false;
};

/// Outlines in grey, edges above them, dots for elements, names beside the dots.
std::string connectivity_svg(const std::vector<ConnectivityNode>& nodes, const std::vector<std::pair<int, int>>& edges,
                             const Box& canvas);

/// The exemplar's own, elements numbered from 1 in the order of the drawing; those that cannot be chosen are marked.
std::string numbering_svg(const Exemplar& exemplar, const Box& canvas);

}  // namespace rinceau
