#pragma once
// What has grown so far: elements and seeds, and who is whose neighbour.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/index.h"
#include "geometry/index_map.h"
#include "geometry/random.h"
#include "growth/arrangement/arrange_options.h"
#include "growth/arrangement/node_grid.h"
#include "growth/arrangement/seed_queue.h"

namespace rinceau {

/// A neighbour of a node, kept at both ends.
struct RingLink {
    int other = 0;   ///< node
    int place = -1;  ///< of the reference's ring that it fills; -1 = none
    Point target;    ///< where the reference wants it, relative to the node
};

struct ArrangementNode {
    Point position;
    int symbol = -1;     ///< -1 = any (a seed only)
    int reference = -1;  ///< element of the exemplar; -1 = a seed
    double angle = 0;    ///< that the reference's ring is turned by
    std::vector<RingLink> links;
    bool held = false;  ///< is not moved by relaxation
    bool dead = false;
    std::array<int, 2> lattice{};
    int birth = -1;  ///< of elements: how many were placed before
};

/// A value. Indices of nodes stay as long as it grows.
struct ElementArrangement {
    ArrangeOptions options;
    std::vector<ArrangementNode> nodes;
    std::size_t elements = 0;  ///< nodes that are no seeds and not dead
    Random random{1};
    NodeGrid grid;                    ///< holds every node that is not dead
    SeedQueue queue;                  ///< holds every seed, or it waits there
    std::vector<std::size_t> counts;  ///< elements of each symbol
    std::optional<Point> start;       ///< of the first seed: distances are measured from it
    IndexMap sites;                   ///< of a lattice: site -> node
    int births = 0;                   ///< elements placed so far
    std::size_t relaxed = 0;          ///< elements when the whole was relaxed last
};

inline const ArrangementNode& node_of(const ElementArrangement& arrangement, int node) {
    return arrangement.nodes[at(node)];
}
inline ArrangementNode& node_of(ElementArrangement& arrangement, int node) { return arrangement.nodes[at(node)]; }

inline bool is_element(const ArrangementNode& node) { return node.reference >= 0 && !node.dead; }
inline bool is_seed(const ArrangementNode& node) { return node.reference < 0 && !node.dead; }

}  // namespace rinceau
