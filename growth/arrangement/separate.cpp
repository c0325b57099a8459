#include "growth/arrangement/separate.h"

#include <algorithm>

#include "growth/arrangement/node_links.h"
#include "growth/arrangement/outline_contact.h"
#include "growth/arrangement/stay_inside.h"

namespace rinceau {

namespace {

constexpr double tolerance = 1e-6;  // of the least distance: what is so near to it is at it

void move_unless_barred(ElementArrangement& arrangement, const GrowthGround& ground, int node, Point to) {
    const ArrangementNode& moved = node_of(arrangement, node);
    if (is_barred(ground, moved.position, to)) return;
    if (ground.exclusive && !overlapped_elements(arrangement, ground, {moved.reference, to, moved.angle}, node).empty())
        return;
    move_node(arrangement, node, to);
}

/// An element that is too near, and by how much.
struct CrowdingElement {
    int node = 0;
    double missing = 0;
};

std::vector<CrowdingElement> nearer_than_allowed(const ElementArrangement& arrangement, const GrowthGround& ground,
                                                 int node) {
    const ArrangementNode& center = arrangement.nodes[static_cast<std::size_t>(node)];
    const auto symbol = static_cast<std::size_t>(center.symbol);
    std::vector<CrowdingElement> near;
    arrangement.grid.visit(center.position, ground.reach_of[symbol], [&](int other, Point position) {
        const ArrangementNode& second = arrangement.nodes[static_cast<std::size_t>(other)];
        if (other == node || !is_element(second)) return;
        const double least = ground.least[symbol][static_cast<std::size_t>(second.symbol)];
        const double distance = abs(position - center.position);
        if (distance < (1 - tolerance) * least) near.push_back({other, least - distance});
    });
    return near;
}

// Pushes one element and those around it apart; adds what has moved.
void push_apart(ElementArrangement& arrangement, const GrowthGround& ground, int node, std::vector<int>& moved) {
    const Point at = node_of(arrangement, node).position;
    for (const CrowdingElement& crowding : nearer_than_allowed(arrangement, ground, node)) {
        const ArrangementNode& a = node_of(arrangement, node);
        const ArrangementNode& b = node_of(arrangement, crowding.node);
        // What was gained by the pushes before this one.
        const Point way = parting_way(at, b.position);
        const double missing = crowding.missing - dot(at - a.position, way);
        if (missing <= 0 || (a.held && b.held)) continue;
        const double share = a.held ? 0 : b.held ? 1 : 0.5;
        move_unless_barred(arrangement, ground, node, a.position - share * missing * way);
        move_unless_barred(arrangement, ground, crowding.node, b.position + (1 - share) * missing * way);
        if (!a.held) moved.push_back(node);
        if (!b.held) moved.push_back(crowding.node);
    }
}

}  // namespace

void separate(ElementArrangement& arrangement, const GrowthGround& ground, const std::vector<int>& nodes, int passes) {
    std::vector<int> wave = nodes;
    if (ground.options.mode == RotationMode::flow && !ground.exemplar.irregular) passes = 0;
    for (int pass = 0; pass < passes && !wave.empty(); ++pass) {
        std::vector<int> moved;
        for (const int node : wave)
            if (is_element(node_of(arrangement, node))) push_apart(arrangement, ground, node, moved);
        std::sort(moved.begin(), moved.end());
        moved.erase(std::unique(moved.begin(), moved.end()), moved.end());
        push_inside(arrangement, ground, moved);
        wave = std::move(moved);
    }
    push_inside(arrangement, ground, nodes);
}

}  // namespace rinceau
