#include "growth/arrangement/separate.h"

#include <algorithm>

#include "growth/arrangement/node_links.h"
#include "growth/arrangement/stay_inside.h"

namespace rinceau {

namespace {

constexpr double tolerance = 1e-6;  // of the least distance: what is so near to it is at it

ArrangementNode& node_of(ElementArrangement& arrangement, int node) {
    return arrangement.nodes[static_cast<std::size_t>(node)];
}

void move_unless_barred(ElementArrangement& arrangement, const GrowthGround& ground, int node, Point to) {
    if (!is_barred(ground, node_of(arrangement, node).position, to)) move_node(arrangement, node, to);
}

// Pushes one element and those around it apart; adds what has moved.
void push_apart(ElementArrangement& arrangement, const GrowthGround& ground, int node, std::vector<int>& moved) {
    struct Near {
        int node;
        double distance;
    };
    std::vector<Near> near;
    const Point at = node_of(arrangement, node).position;
    const auto symbol = static_cast<std::size_t>(node_of(arrangement, node).symbol);
    arrangement.grid.visit(at, ground.reach_of[symbol], [&](int other, Point position) {
        if (other == node || !is_element(node_of(arrangement, other))) return;
        const double least = ground.least[symbol][static_cast<std::size_t>(node_of(arrangement, other).symbol)];
        if (abs(position - at) < (1 - tolerance) * least) near.push_back({other, least});
    });
    for (const Near& pair : near) {
        ArrangementNode& a = node_of(arrangement, node);
        ArrangementNode& b = node_of(arrangement, pair.node);
        const Point between = b.position - a.position;
        const double distance = abs(between);
        if (distance >= pair.distance || (a.held && b.held)) continue;
        // Of two in the same place one goes right: any way is as good.
        const Point way = distance > 0 ? between / distance : Point{1, 0};
        const double missing = pair.distance - distance;
        const double share = a.held ? 0 : b.held ? 1 : 0.5;
        move_unless_barred(arrangement, ground, node, a.position - share * missing * way);
        move_unless_barred(arrangement, ground, pair.node, b.position + (1 - share) * missing * way);
        if (!a.held) moved.push_back(node);
        if (!b.held) moved.push_back(pair.node);
    }
}

}  // namespace

void separate(ElementArrangement& arrangement, const GrowthGround& ground, const std::vector<int>& nodes, int passes) {
    std::vector<int> wave = nodes;
    if (ground.options.mode == RotationMode::flow) passes = 0;
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
