// The paper holds elements at a boundary where they were born, which keeps their faults; here relaxation moves all, and
// those that come over a line are moved back by what their outline reaches over it.
#include "growth/arrangement/stay_inside.h"

#include "geometry/similarity.h"
#include "growth/arrangement/node_links.h"
#include "growth/arrangement/outline_contact.h"

namespace rinceau {

namespace {

constexpr double clearance = 1e-3;  // of a mean edge: what only touches counts as cut
constexpr int push_rounds = 4;      // one for each line of a corner, and again
constexpr double crowded = 0.85;    // of the least distance of two kinds, as where seeds are set

}  // namespace

bool is_cut(const GrowthGround& ground, int reference, double angle, Point at) {
    const Boundary* boundary = ground.around.boundary.get();
    if (boundary == nullptr || boundary->is_empty()) return false;
    const ExemplarElement& element = ground.exemplar.elements[static_cast<std::size_t>(reference)];
    if (!boundary->nearest(at, element.radius)) return !boundary->allows(at);
    return boundary->cuts(element.outline, translate(at) * rotate(angle));
}

Point pushed_inside(const GrowthGround& ground, int reference, double angle, Point at) {
    const Boundary* boundary = ground.around.boundary.get();
    if (boundary == nullptr || boundary->is_empty() || ground.rigid) return at;
    const ExemplarElement& element = ground.exemplar.elements[static_cast<std::size_t>(reference)];
    const double margin = clearance * ground.exemplar.mean_edge;
    for (int round = 0; round < push_rounds; ++round) {
        const bool outside = !boundary->allows(at);
        const std::optional<Point> line =
            boundary->nearest(at, element.radius + margin + (outside ? ground.exemplar.mean_edge : 0));
        if (!line) return at;
        const double distance = abs(at - *line);
        if (!(distance > 0)) return at;
        const Point away = ((outside ? -1 : 1) / distance) * (at - *line);
        const double missing = outline_extent(element, angle, -away) + margin - (outside ? -distance : distance);
        if (missing <= 0) return at;
        at += missing * away;
    }
    return at;
}

bool is_crowded(const ElementArrangement& arrangement, const GrowthGround& ground, int node, int reference, Point to) {
    if (ground.options.mode != RotationMode::flow || ground.exclusive) return false;
    const ArrangementNode& pushed = arrangement.nodes[static_cast<std::size_t>(node)];
    const int symbol = ground.exemplar.elements[static_cast<std::size_t>(reference)].symbol;
    bool found = false;
    arrangement.grid.visit(to, crowded * ground.reach, [&](int other, Point position) {
        const ArrangementNode& beside = arrangement.nodes[static_cast<std::size_t>(other)];
        if (found || other == node || !is_element(beside)) return;
        const double distance = abs(position - to);
        if (is_element(pushed) && distance >= abs(position - pushed.position)) return;
        found = distance < crowded * least_distance(ground, symbol, beside.symbol);
    });
    return found;
}

void push_inside(ElementArrangement& arrangement, const GrowthGround& ground, const std::vector<int>& nodes) {
    if (ground.around.boundary == nullptr || ground.around.boundary->is_empty() || ground.rigid) return;
    for (const int index : nodes) {
        const ArrangementNode& node = arrangement.nodes[static_cast<std::size_t>(index)];
        if (!is_element(node) || node.held) continue;
        const Point to = pushed_inside(ground, node.reference, node.angle, node.position);
        if (to == node.position || is_crowded(arrangement, ground, index, node.reference, to)) continue;
        // From outside the region the way in leads over its line.
        const Boundary& boundary = *ground.around.boundary;
        if (boundary.allows(node.position) ? !is_barred(ground, node.position, to) : boundary.allows(to))
            move_node(arrangement, index, to);
    }
}

}  // namespace rinceau
