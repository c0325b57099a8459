// Ijiri et al. 2008, eq. 5, by coordinate descent: the best place of one node is the mean of where its neighbours want it
// and of where it sees itself from them, so that no step can raise the energy. Links without a place have no term: the paper
// takes their present shape for their target, which keeps every fault as it is.
#include "growth/arrangement/relax_near.h"

#include <algorithm>
#include <optional>

#include "growth/arrangement/node_links.h"
#include "growth/arrangement/outline_contact.h"

namespace rinceau {

namespace {

std::optional<Point> best_position(const ElementArrangement& arrangement, int node) {
    Point sum;
    int count = 0;
    for (const RingLink& link : node_of(arrangement, node).links) {
        const Point other = node_of(arrangement, link.other).position;
        if (link.place >= 0) {
            sum += other - link.target;
            ++count;
        }
        const RingLink* back = link_to(arrangement, link.other, node);
        if (back->place >= 0) {
            sum += other + back->target;
            ++count;
        }
    }
    if (count == 0) return std::nullopt;
    return (1.0 / count) * sum;
}

double fitted_angle(const ElementArrangement& arrangement, const GrowthGround& ground, const ArrangementNode& node) {
    Complex sum;
    for (const RingLink& link : node.links) {
        if (link.place < 0) continue;
        const Point offset =
            ground.rings[static_cast<std::size_t>(node.reference)].offsets[static_cast<std::size_t>(link.place)];
        sum += conj(offset) * (node_of(arrangement, link.other).position - node.position);
    }
    return norm(sum) > 0 ? arg(sum) : node.angle;
}

bool would_overlap(const ElementArrangement& arrangement, const GrowthGround& ground, int node, Point to) {
    const ArrangementNode& moved = node_of(arrangement, node);
    return moved.reference >= 0 &&
           !overlapped_elements(arrangement, ground, {moved.reference, to, moved.angle}, node).empty();
}

}  // namespace

double ring_energy(const ElementArrangement& arrangement) {
    double energy = 0;
    for (const ArrangementNode& node : arrangement.nodes)
        for (const RingLink& link : node.links)
            if (link.place >= 0) energy += norm(node_of(arrangement, link.other).position - node.position - link.target);
    return energy;
}

std::vector<int> nodes_around(const ElementArrangement& arrangement, int node, int links) {
    std::vector<int> found{node};
    std::size_t ring_begin = 0;
    for (int distance = 0; distance < links; ++distance) {
        const std::size_t ring_end = found.size();
        for (std::size_t i = ring_begin; i < ring_end; ++i)
            for (const RingLink& link : node_of(arrangement, found[i]).links)
                if (std::find(found.begin(), found.end(), link.other) == found.end()) found.push_back(link.other);
        ring_begin = ring_end;
    }
    std::reverse(found.begin(), found.end());
    return found;
}

void relax_in_turn(ElementArrangement& arrangement, const GrowthGround& ground, const std::vector<int>& nodes) {
    const bool bounded = ground.around.boundary != nullptr && !ground.around.boundary->is_empty();
    for (const int node : nodes) {
        if (node_of(arrangement, node).held) continue;
        const std::optional<Point> to = best_position(arrangement, node);
        if (!to || (bounded && is_barred(ground, node_of(arrangement, node).position, *to))) continue;
        if (ground.exclusive && would_overlap(arrangement, ground, node, *to)) continue;
        move_node(arrangement, node, *to);
    }
}

void refit_angles(ElementArrangement& arrangement, const GrowthGround& ground, const std::vector<int>& nodes) {
    if (ground.options.mode == RotationMode::fixed) return;
    for (const int index : nodes) {
        ArrangementNode& node = arrangement.nodes[static_cast<std::size_t>(index)];
        // An outline that turned after it was placed could come over another one.
        if (!is_element(node) || ground.exclusive) continue;
        node.angle = ground.options.mode == RotationMode::rotate ? fitted_angle(arrangement, ground, node)
                                                                 : ring_angle(ground, node.position, polar(1, node.angle));
        for (RingLink& link : node.links)
            if (link.place >= 0) link.target = ring_target(ground, node.reference, link.place, node.angle, node.position);
    }
}

}  // namespace rinceau
