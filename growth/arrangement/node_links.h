#pragma once
// Changing an arrangement so that it stays whole: nodes and grid agree, links are kept at both ends.

#include <optional>

#include "growth/arrangement/element_arrangement.h"

namespace rinceau {

/// The number of the new node, a seed without links.
int add_seed(ElementArrangement& arrangement, Point at, int symbol);
/// Moves a node; links keep their targets.
void move_node(ElementArrangement& arrangement, int node, Point to);
/// Takes a node and its links away; seeds that wait for it do not any more.
void remove_node(ElementArrangement& arrangement, int node);

/// An element becomes a seed of its symbol again; its neighbours keep it in their rings.
void become_seed(ElementArrangement& arrangement, int element);

/// The link of `node` to `other`, or null.
RingLink* link_to(ElementArrangement& arrangement, int node, int other);
const RingLink* link_to(const ElementArrangement& arrangement, int node, int other);
/// The node that fills the place of the node's ring, or -1.
int node_at_place(const ElementArrangement& arrangement, int node, int place);
/// Makes two different nodes neighbours, without places, unless they are already.
void join_nodes(ElementArrangement& arrangement, int a, int b);
void part_nodes(ElementArrangement& arrangement, int a, int b);
void drop_links(ElementArrangement& arrangement, int node);

/// The node nearest to `at` within `radius` that is not `except`; ties by number.
std::optional<int> nearest_node(const ElementArrangement& arrangement, Point at, double radius, int except);

/// Does an edge cross the segment between two points? Edges that end in one of the two nodes (-1: none) do not. Finds all
/// edges that are not longer than 1.5 times `longest`.
bool crosses_edge(const ElementArrangement& arrangement, Point from, Point to, int from_node, int to_node, double longest);

}  // namespace rinceau
