// Ijiri et al. 2008, section 5.4 and figure 6. Deviations:
// - The new element is moved to where its matched neighbours want it: errors then do not add up from row to row.
// - r_short is a third of the edge where that is more than the paper's half of the exemplar's shortest, and two kinds that
// keep
//   a distance in the exemplar keep most of it here: the paper's one length for all kinds lets large elements overlap.
// - The ring is closed only where the exemplar's is, so that the cells of a square grid get no diagonals.
// - On a lattice the index of a site says what stands there already; no distance needs to be judged.
#include "growth/arrangement/place_element.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/angle.h"
#include "growth/arrangement/node_links.h"

namespace rinceau {

namespace {

constexpr double same_place = 0.35;  // of the edge: what is nearer to a place is what the place is meant for
constexpr double crowded = 0.85;     // of the least distance of two kinds: nearer than this no seed is set
constexpr double pulled = 0.5;       // of the edge: what is nearer to a place than this is pulled into it
constexpr double too_long = 1.5;     // of the exemplar's: a longer edge gets a seed between (the paper's r_long)

const ReferenceRing& ring_of(const GrowthGround& ground, int reference) {
    return ground.rings[static_cast<std::size_t>(reference)];
}

bool may_join(const ElementArrangement& arrangement, const GrowthGround& ground, Point from, Point to, int from_node,
              int to_node) {
    return !crosses_edge(arrangement, from, to, from_node, to_node, ground.exemplar.longest_edge) &&
           !is_barred(ground, from, to);
}

// The element's end of an edge to another one.
void claim_place(ElementArrangement& arrangement, const GrowthGround& ground, int element, int other) {
    const ArrangementNode& node = node_of(arrangement, element);
    const RingLink* link = link_to(arrangement, element, other);
    if (link == nullptr || link->place >= 0) return;
    const Point offset = node_of(arrangement, other).position - node.position;
    double nearest = 0.5 * ground.exemplar.mean_edge;
    int place = -1;
    for (std::size_t k = 0; k < ring_of(ground, node.reference).offsets.size(); ++k) {
        const int candidate = static_cast<int>(k);
        const double distance = abs(ring_target(ground, node.reference, candidate, node.angle, node.position) - offset);
        if (!(distance < nearest) || node_at_place(arrangement, element, candidate) >= 0) continue;
        nearest = distance;
        place = candidate;
    }
    if (place >= 0) fill_place(arrangement, ground, element, other, place);
}

int new_seed(ElementArrangement& arrangement, Point at, int symbol, std::array<int, 2> lattice) {
    const int seed = add_seed(arrangement, at, symbol);
    node_of(arrangement, seed).lattice = lattice;
    return seed;
}

// Is an edge of the node nearer in angle to the direction than half the angle that the place has to itself?
bool edge_stands_in_direction(const ElementArrangement& arrangement, int node, Point direction, double half_gap_cos) {
    const ArrangementNode& center = arrangement.nodes[static_cast<std::size_t>(node)];
    return std::any_of(center.links.begin(), center.links.end(), [&](const RingLink& link) {
        const Point edge = arrangement.nodes[static_cast<std::size_t>(link.other)].position - center.position;
        return dot(edge, direction) > half_gap_cos * abs(edge) * abs(direction);
    });
}

// Links the element's place with a node that stands already, unless that is in another place of the ring.
void use_for_place(ElementArrangement& arrangement, const GrowthGround& ground, int element, int other, int place,
                   bool with_target) {
    const RingLink* link = link_to(arrangement, element, other);
    if (link != nullptr && link->place >= 0) return;
    if (link == nullptr) {
        const Point from = node_of(arrangement, element).position;
        if (!may_join(arrangement, ground, from, node_of(arrangement, other).position, element, other)) return;
        join_nodes(arrangement, element, other);
    }
    if (with_target) fill_place(arrangement, ground, element, other, place);
    if (is_element(node_of(arrangement, other))) claim_place(arrangement, ground, other, element);
}

// The nearest node that stands too close to the place for a seed of that kind.
std::optional<int> crowding_node(const ElementArrangement& arrangement, const GrowthGround& ground, Point at, int symbol,
                                 int except) {
    std::optional<int> best;
    double best_distance = 0;
    arrangement.grid.visit(at, crowded * std::max(ground.reach, ground.exemplar.shortest_edge),
                           [&](int node, Point position) {
                               if (node == except) return;
                               const double distance = abs(position - at);
                               const int other = arrangement.nodes[static_cast<std::size_t>(node)].symbol;
                               if (distance >= crowded * least_distance(ground, symbol, other)) return;
                               if (best && (distance > best_distance || (distance == best_distance && node > *best))) return;
                               best = node;
                               best_distance = distance;
                           });
    return best;
}

// The element's place on a lattice: whatever stands at the site, or a seed.
std::optional<int> complete_site(ElementArrangement& arrangement, const GrowthGround& ground, int element, int place,
                                 Point at) {
    const ArrangementNode& node = node_of(arrangement, element);
    const ReferenceRing& ring = ring_of(ground, node.reference);
    const std::array<int, 2> step = ring.steps[static_cast<std::size_t>(place)];
    const std::array<int, 2> site{node.lattice[0] + step[0], node.lattice[1] + step[1]};
    const int there = arrangement.sites.find(site_key(site));
    if (there >= 0 && !node_of(arrangement, there).dead) {
        if (is_barred(ground, node.position, node_of(arrangement, there).position)) return std::nullopt;
        join_nodes(arrangement, element, there);
        fill_place(arrangement, ground, element, there, place);
        if (!is_element(node_of(arrangement, there))) return std::nullopt;
        const ReferenceRing& other = ring_of(ground, node_of(arrangement, there).reference);
        const auto back = std::find(other.steps.begin(), other.steps.end(), std::array<int, 2>{-step[0], -step[1]});
        if (back != other.steps.end())
            fill_place(arrangement, ground, there, element, static_cast<int>(back - other.steps.begin()));
        return std::nullopt;
    }
    if (is_barred(ground, node.position, at)) return std::nullopt;
    const int seed = new_seed(arrangement, at, seed_symbol(ground, ring.symbols[static_cast<std::size_t>(place)]), site);
    arrangement.sites.set(site_key(site), seed);
    join_nodes(arrangement, element, seed);
    fill_place(arrangement, ground, element, seed, place);
    return seed;
}

// The element's place where no lattice is known: figure 6 of the paper.
std::optional<int> complete_place(ElementArrangement& arrangement, const GrowthGround& ground, int element, int place,
                                  Point at) {
    const ArrangementNode& node = node_of(arrangement, element);
    const ReferenceRing& ring = ring_of(ground, node.reference);
    const auto k = static_cast<std::size_t>(place);
    const double length = ring.lengths[k];
    // Step b: something is there already.
    const double same =
        std::min(std::max(0.5 * ground.exemplar.shortest_edge, same_place * length), 0.5 * ground.exemplar.mean_edge);
    if (const std::optional<int> there = nearest_node(arrangement, at, same, element)) {
        use_for_place(arrangement, ground, element, *there, place, true);
        return std::nullopt;
    }
    // Step c: something stands too close.
    if (const std::optional<int> close = crowding_node(arrangement, ground, at, ring.symbols[k], element)) {
        const bool pull = abs(node_of(arrangement, *close).position - at) < pulled * length;
        use_for_place(arrangement, ground, element, *close, place, pull);
        return std::nullopt;
    }
    // Steps d, e and f: no room between the edges, an edge or a line in the way.
    if (edge_stands_in_direction(arrangement, element, at - node.position, ring.half_gap_cos[k])) return std::nullopt;
    if (!may_join(arrangement, ground, node.position, at, element, -1)) return std::nullopt;
    // Step g.
    const int seed = new_seed(arrangement, at, seed_symbol(ground, ring.symbols[k]), {});
    join_nodes(arrangement, element, seed);
    fill_place(arrangement, ground, element, seed, place);
    return seed;
}

// A seed of any kind in the middle of a gap (figure 6e), if there is room.
std::optional<int> fill_gap(ElementArrangement& arrangement, const GrowthGround& ground, int element, int before,
                            int after) {
    const Point center = node_of(arrangement, element).position;
    const Point a = node_of(arrangement, before).position - center;
    const Point b = node_of(arrangement, after).position - center;
    double angle = std::atan2(cross(a, b), dot(a, b));
    if (angle <= 0) angle += two_pi;
    const Point at = center + (0.5 * (abs(a) + abs(b)) / abs(a)) * (polar(1, 0.5 * angle) * a);
    if (nearest_node(arrangement, at, 0.5 * ground.exemplar.shortest_edge, element)) return std::nullopt;
    if (!may_join(arrangement, ground, center, at, element, -1)) return std::nullopt;
    const int seed = new_seed(arrangement, at, -1, {});
    join_nodes(arrangement, element, seed);
    for (const int neighbor : {before, after})
        if (may_join(arrangement, ground, at, node_of(arrangement, neighbor).position, seed, neighbor))
            join_nodes(arrangement, seed, neighbor);
    return seed;
}

std::vector<int> close_ring(ElementArrangement& arrangement, const GrowthGround& ground, int element) {
    const int reference = node_of(arrangement, element).reference;
    const ExemplarRing& ring = ground.exemplar.elements[static_cast<std::size_t>(reference)].ring;
    std::vector<int> seeds;
    for (std::size_t k = 0; k < ring.offsets.size(); ++k) {
        if (!ring.joined[k]) continue;
        const std::size_t next = (k + 1) % ring.offsets.size();
        const int a = node_at_place(arrangement, element, static_cast<int>(k));
        const int b = node_at_place(arrangement, element, static_cast<int>(next));
        if (a < 0 || b < 0 || a == b || link_to(arrangement, a, b) != nullptr) continue;
        const Point from = node_of(arrangement, a).position;
        const Point to = node_of(arrangement, b).position;
        if (abs(to - from) > too_long * abs(ring.offsets[next] - ring.offsets[k])) {
            if (const std::optional<int> seed = fill_gap(arrangement, ground, element, a, b)) seeds.push_back(*seed);
        } else if (may_join(arrangement, ground, from, to, a, b)) {
            join_nodes(arrangement, a, b);
            claim_places(arrangement, ground, a, b);
        }
    }
    return seeds;
}

}  // namespace

void fill_place(ElementArrangement& arrangement, const GrowthGround& ground, int element, int other, int place) {
    const ArrangementNode& node = node_of(arrangement, element);
    RingLink* link = link_to(arrangement, element, other);
    link->place = place;
    link->target = ring_target(ground, node.reference, place, node.angle, node.position);
}

void become_element(ElementArrangement& arrangement, const GrowthGround& ground, int seed, int reference, double angle) {
    ArrangementNode& node = node_of(arrangement, seed);
    node.reference = reference;
    node.symbol = ground.exemplar.elements[static_cast<std::size_t>(reference)].symbol;
    node.angle = angle;
    node.birth = arrangement.births++;
    ++arrangement.elements;
    ++arrangement.counts[static_cast<std::size_t>(node.symbol)];
}

std::uint64_t site_key(std::array<int, 2> site) {
    return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(site[0])) << 32U) | static_cast<std::uint32_t>(site[1]);
}

int seed_symbol(const GrowthGround& ground, int symbol) {
    return symbol >= 0 && ground.usable_of[static_cast<std::size_t>(symbol)].empty() ? -1 : symbol;
}

void claim_places(ElementArrangement& arrangement, const GrowthGround& ground, int a, int b) {
    if (!is_element(node_of(arrangement, a)) || !is_element(node_of(arrangement, b))) return;
    claim_place(arrangement, ground, a, b);
    claim_place(arrangement, ground, b, a);
}

std::vector<int> complete_ring(ElementArrangement& arrangement, const GrowthGround& ground, int element) {
    std::vector<int> seeds;
    const std::size_t places = ring_of(ground, node_of(arrangement, element).reference).offsets.size();
    for (std::size_t k = 0; k < places; ++k) {
        const int place = static_cast<int>(k);
        if (node_at_place(arrangement, element, place) >= 0) continue;
        const ArrangementNode& node = node_of(arrangement, element);
        const Point at = node.position + ring_target(ground, node.reference, place, node.angle, node.position);
        const std::optional<int> seed = ground.by_lattice ? complete_site(arrangement, ground, element, place, at)
                                                          : complete_place(arrangement, ground, element, place, at);
        if (seed) seeds.push_back(*seed);
    }
    if (!ground.by_lattice) {
        const std::vector<int> between = close_ring(arrangement, ground, element);
        seeds.insert(seeds.end(), between.begin(), between.end());
    }
    return seeds;
}

// Seeds have no say: they are where elements wanted them.
Point fitted_position(const ElementArrangement& arrangement, const GrowthGround& ground, int seed, const TargetRing& ring,
                      const ReferenceMatch& match) {
    const Point from = arrangement.nodes[static_cast<std::size_t>(seed)].position;
    if (arrangement.nodes[static_cast<std::size_t>(seed)].held) return from;
    Point sum;
    int count = 0;
    for (std::size_t i = 0; i < ring.inner.size(); ++i) {
        const ArrangementNode& neighbor = arrangement.nodes[static_cast<std::size_t>(ring.inner[i].node)];
        if (match.places[i] < 0 || neighbor.reference < 0) continue;
        sum += neighbor.position - ring_target(ground, match.reference, match.places[i], match.angle, from);
        ++count;
    }
    if (count == 0) return from;
    const Point to = (1.0 / count) * sum;
    return abs(to - from) < 0.5 * ground.exemplar.shortest_edge && !is_barred(ground, from, to) ? to : from;
}

std::vector<int> place_element(ElementArrangement& arrangement, const GrowthGround& ground, int seed, const TargetRing& ring,
                               const ReferenceMatch& match, Point at) {
    move_node(arrangement, seed, at);
    become_element(arrangement, ground, seed, match.reference, match.angle);
    for (std::size_t i = 0; i < ring.inner.size(); ++i) {
        const int other = ring.inner[i].node;
        if (match.places[i] >= 0) fill_place(arrangement, ground, seed, other, match.places[i]);
        if (is_element(node_of(arrangement, other))) claim_place(arrangement, ground, other, seed);
    }
    return complete_ring(arrangement, ground, seed);
}

}  // namespace rinceau
