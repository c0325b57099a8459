#include "growth/arrangement/node_links.h"

#include <algorithm>
#include <cassert>

namespace rinceau {

namespace {

void erase_link(ArrangementNode& node, int other) {
    std::erase_if(node.links, [&](const RingLink& link) { return link.other == other; });
}

// Do the inner parts of two segments cross? What only touches does not.
bool segments_cross(Point a, Point b, Point c, Point d) {
    const Point ab = b - a;
    const double side_c = cross(ab, c - a);
    const double side_d = cross(ab, d - a);
    if ((side_c >= 0) == (side_d >= 0) || side_c == 0 || side_d == 0) return false;
    const Point cd = d - c;
    const double side_a = cross(cd, a - c);
    const double side_b = cross(cd, b - c);
    return (side_a >= 0) != (side_b >= 0) && side_a != 0 && side_b != 0;
}

}  // namespace

int add_seed(ElementArrangement& arrangement, Point at, int symbol) {
    const int node = static_cast<int>(arrangement.nodes.size());
    ArrangementNode seed;
    seed.position = at;
    seed.symbol = symbol;
    arrangement.nodes.push_back(std::move(seed));
    arrangement.grid.insert(node, at);
    return node;
}

void move_node(ElementArrangement& arrangement, int node, Point to) {
    node_of(arrangement, node).position = to;
    arrangement.grid.move(node, to);
}

void remove_node(ElementArrangement& arrangement, int node) {
    ArrangementNode& gone = node_of(arrangement, node);
    assert(!gone.dead);
    if (gone.reference >= 0) {
        --arrangement.elements;
        --arrangement.counts[static_cast<std::size_t>(gone.symbol)];
    }
    drop_links(arrangement, node);
    arrangement.grid.remove(node);
    arrangement.queue.release(node);
    gone.dead = true;
}

void become_seed(ElementArrangement& arrangement, int element) {
    ArrangementNode& node = node_of(arrangement, element);
    --arrangement.elements;
    --arrangement.counts[static_cast<std::size_t>(node.symbol)];
    node.reference = -1;
    for (RingLink& link : node.links) link.place = -1;
    arrangement.queue.push({abs(node.position - *arrangement.start), element});
}

RingLink* link_to(ElementArrangement& arrangement, int node, int other) {
    for (RingLink& link : node_of(arrangement, node).links)
        if (link.other == other) return &link;
    return nullptr;
}

const RingLink* link_to(const ElementArrangement& arrangement, int node, int other) {
    for (const RingLink& link : node_of(arrangement, node).links)
        if (link.other == other) return &link;
    return nullptr;
}

int node_at_place(const ElementArrangement& arrangement, int node, int place) {
    for (const RingLink& link : node_of(arrangement, node).links)
        if (link.place == place) return link.other;
    return -1;
}

void join_nodes(ElementArrangement& arrangement, int a, int b) {
    assert(a != b);
    if (link_to(arrangement, a, b) != nullptr) return;
    node_of(arrangement, a).links.push_back({.other = b});
    node_of(arrangement, b).links.push_back({.other = a});
}

void part_nodes(ElementArrangement& arrangement, int a, int b) {
    erase_link(node_of(arrangement, a), b);
    erase_link(node_of(arrangement, b), a);
}

void drop_links(ElementArrangement& arrangement, int node) {
    for (const RingLink& link : node_of(arrangement, node).links) erase_link(node_of(arrangement, link.other), node);
    node_of(arrangement, node).links.clear();
}

std::optional<int> nearest_node(const ElementArrangement& arrangement, Point at, double radius, int except) {
    std::optional<int> best;
    double best_distance = 0;
    arrangement.grid.visit(at, radius, [&](int node, Point position) {
        if (node == except) return;
        const double distance = norm(position - at);
        if (best && (distance > best_distance || (distance == best_distance && node > *best))) return;
        best = node;
        best_distance = distance;
    });
    return best;
}

bool crosses_edge(const ElementArrangement& arrangement, Point from, Point to, int from_node, int to_node, double longest) {
    // An edge that crosses has an end within half of both lengths of the middle.
    const double reach = 0.5 * abs(to - from) + 0.75 * longest;
    bool crosses = false;
    arrangement.grid.visit(0.5 * (from + to), reach, [&](int node, Point position) {
        if (crosses || node == from_node || node == to_node) return;
        for (const RingLink& link : node_of(arrangement, node).links) {
            if (link.other == from_node || link.other == to_node) continue;
            if (segments_cross(from, to, position, node_of(arrangement, link.other).position)) {
                crosses = true;
                return;
            }
        }
    });
    return crosses;
}

}  // namespace rinceau
