#pragma once
// What has grown so far: elements and seeds, and who is whose neighbour.

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/random.h"
#include "growth/arrangement/arrange_options.h"

namespace rinceau {

/// A neighbour of a node, kept at both ends.
struct RingLink {
    int other = 0;        ///< node
    int place = -1;       ///< of the reference's ring that it fills; -1 = none
    Point target;         ///< where the reference wants it, relative to the node
};

struct ArrangementNode {
    Point position;
    int symbol = -1;      ///< -1 = any (a seed only)
    int reference = -1;   ///< element of the exemplar; -1 = a seed
    double angle = 0;     ///< that the reference's ring is turned by
    std::vector<RingLink> links;
    bool held = false;    ///< is not moved by relaxation
    bool dead = false;
    std::array<int, 2> lattice{};
};

/// A value. Indices of nodes stay as long as it grows.
struct ElementArrangement {
    ArrangeOptions options;
    std::vector<ArrangementNode> nodes;
    std::size_t elements = 0;  ///< nodes that are no seeds and not dead
    Random random{1};
};

}  // namespace rinceau
