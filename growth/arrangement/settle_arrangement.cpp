// A curved flow has no room for equal distances: a global solve would spread the mismatch into density (a square grid about
// a vortex: 22 % too dense, some distances halved), so that there only the neighbourhood of what is new is relaxed.
#include "growth/arrangement/settle_arrangement.h"

#include "growth/arrangement/node_links.h"
#include "growth/arrangement/relax_all.h"
#include "growth/arrangement/relax_near.h"
#include "growth/arrangement/separate.h"

namespace rinceau {

namespace {

constexpr int near_links = 2;
constexpr int near_sweeps = 2;
constexpr int near_passes = 2;

std::vector<int> living_nodes(const ElementArrangement& arrangement) {
    std::vector<int> nodes;
    for (std::size_t i = 0; i < arrangement.nodes.size(); ++i)
        if (!arrangement.nodes[i].dead) nodes.push_back(static_cast<int>(i));
    return nodes;
}

// The solve knows no lines: who was led over one goes back.
void return_from_beyond_lines(ElementArrangement& arrangement, const GrowthGround& ground,
                              const std::vector<Point>& before) {
    for (std::size_t i = 0; i < before.size(); ++i)
        if (!arrangement.nodes[i].dead && arrangement.nodes[i].position != before[i] &&
            is_barred(ground, before[i], arrangement.nodes[i].position))
            move_node(arrangement, static_cast<int>(i), before[i]);
}

}  // namespace

void settle_near(ElementArrangement& arrangement, const GrowthGround& ground, int element) {
    const std::vector<int> nodes = nodes_around(arrangement, element, near_links);
    for (int sweep = 0; sweep < near_sweeps; ++sweep) {
        relax_in_turn(arrangement, ground, nodes);
        refit_angles(arrangement, ground, nodes);
    }
    separate(arrangement, ground, nodes, near_passes);
}

void settle_all(ElementArrangement& arrangement, const GrowthGround& ground, int rounds, int separation_passes) {
    const std::vector<int> nodes = living_nodes(arrangement);
    if (ground.options.mode != RotationMode::flow) {
        std::vector<Point> before;
        if (ground.around.boundary != nullptr && !ground.around.boundary->is_empty())
            for (const ArrangementNode& node : arrangement.nodes) before.push_back(node.position);
        relax_all(arrangement, ground, rounds);
        return_from_beyond_lines(arrangement, ground, before);
    }
    separate(arrangement, ground, nodes, separation_passes);
}

}  // namespace rinceau
