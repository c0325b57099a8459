#include "growth/arrangement/untangle_outlines.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "growth/arrangement/choose_reference.h"
#include "growth/arrangement/node_links.h"
#include "growth/arrangement/outline_contact.h"
#include "growth/arrangement/place_element.h"
#include "growth/arrangement/stay_inside.h"

namespace rinceau {

namespace {

constexpr int untangle_rounds = 16;
constexpr double small_push = 0.06;   // mean edges: so little is not seen
constexpr double largest_push = 0.3;  // mean edges, in one round

using ElementPair = std::pair<int, int>;

std::vector<int> all_elements(const ElementArrangement& arrangement) {
    std::vector<int> elements;
    for (std::size_t i = 0; i < arrangement.nodes.size(); ++i)
        if (is_element(arrangement.nodes[i])) elements.push_back(static_cast<int>(i));
    return elements;
}

// Pairs that overlap and have one of the elements in them, each once, sorted.
std::vector<ElementPair> overlapping_pairs_of(const ElementArrangement& arrangement, const GrowthGround& ground,
                                              const std::vector<int>& elements) {
    std::vector<char> asked(arrangement.nodes.size(), 0);
    std::vector<ElementPair> pairs;
    for (const int element : elements) {
        const ArrangementNode& node = arrangement.nodes[static_cast<std::size_t>(element)];
        if (!is_element(node) || asked[static_cast<std::size_t>(element)] != 0) continue;
        asked[static_cast<std::size_t>(element)] = 1;
        const PlacedReference placed = placed_reference(node);
        const double reach =
            ground.exemplar.elements[static_cast<std::size_t>(node.reference)].radius + ground.largest_radius;
        arrangement.grid.visit(node.position, reach, [&](int other, Point) {
            const ArrangementNode& second = arrangement.nodes[static_cast<std::size_t>(other)];
            if (asked[static_cast<std::size_t>(other)] != 0 || !is_element(second)) return;
            if (outlines_overlap(ground, placed, placed_reference(second))) pairs.push_back(std::minmax(element, other));
        });
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

bool overlap_now(const ElementArrangement& arrangement, const GrowthGround& ground, const ElementPair& pair) {
    const ArrangementNode& a = arrangement.nodes[static_cast<std::size_t>(pair.first)];
    const ArrangementNode& b = arrangement.nodes[static_cast<std::size_t>(pair.second)];
    return is_element(a) && is_element(b) && outlines_overlap(ground, placed_reference(a), placed_reference(b));
}

void push_pair(ElementArrangement& arrangement, const GrowthGround& ground, const ElementPair& pair, double distance) {
    const ArrangementNode& a = node_of(arrangement, pair.first);
    const ArrangementNode& b = node_of(arrangement, pair.second);
    const Point way = parting_way(a.position, b.position);
    const double share = a.held ? 0 : b.held ? 1 : 0.5;
    const auto move = [&](int node, Point to) {
        const ArrangementNode& moved = node_of(arrangement, node);
        const Point inside = pushed_inside(ground, moved.reference, moved.angle, to);
        if (!is_barred(ground, moved.position, inside)) move_node(arrangement, node, inside);
    };
    move(pair.first, a.position - share * distance * way);
    move(pair.second, b.position + (1 - share) * distance * way);
}

// Another element of the kind, cheapest first, whose outline is free there.
bool exchange(ElementArrangement& arrangement, const GrowthGround& ground, int element) {
    const ArrangementNode& node = node_of(arrangement, element);
    const TargetRing ring = target_ring(arrangement, ground, element);
    RingMatcher matcher(ground, ground.options.weights);
    const ReferenceCharges charges(arrangement, ground, node.position, element);
    std::vector<ReferenceMatch> matches;
    for (const int reference : ground.usable_of[static_cast<std::size_t>(node.symbol)]) {
        if (reference == node.reference) continue;
        ReferenceMatch match =
            matcher.match_near(ring, reference, node.angle, charges.of(reference), std::numeric_limits<double>::infinity());
        if (match.reference >= 0) matches.push_back(std::move(match));
    }
    std::stable_sort(matches.begin(), matches.end(), [](const auto& a, const auto& b) { return a.cost < b.cost; });
    for (const ReferenceMatch& match : matches) {
        if (is_cut(ground, match.reference, match.angle, node.position)) continue;
        if (!overlapped_elements(arrangement, ground, {match.reference, node.position, match.angle}, element).empty())
            continue;
        ArrangementNode& changed = node_of(arrangement, element);
        changed.reference = match.reference;
        changed.angle = match.angle;
        for (RingLink& link : changed.links) link.place = -1;
        for (std::size_t k = 0; k < ring.inner.size(); ++k)
            if (match.places[k] >= 0) fill_place(arrangement, ground, element, ring.inner[k].node, match.places[k]);
        return true;
    }
    return false;
}

}  // namespace

void untangle_outlines(ElementArrangement& arrangement, const GrowthGround& ground) {
    std::vector<int> changed = all_elements(arrangement);
    std::vector<char> tried(arrangement.nodes.size(), 0);
    const auto exchange_once = [&](int element) {
        if (tried[static_cast<std::size_t>(element)] != 0) return false;
        tried[static_cast<std::size_t>(element)] = 1;
        return exchange(arrangement, ground, element);
    };
    for (int round = 0; round < untangle_rounds && !changed.empty(); ++round) {
        const std::vector<ElementPair> pairs = overlapping_pairs_of(arrangement, ground, changed);
        changed.clear();
        for (const ElementPair& pair : pairs) {
            if (!overlap_now(arrangement, ground, pair)) continue;
            changed.push_back(pair.first);
            changed.push_back(pair.second);
            const ArrangementNode& a = node_of(arrangement, pair.first);
            const ArrangementNode& b = node_of(arrangement, pair.second);
            const double missing = parting_distance(ground, placed_reference(a), placed_reference(b));
            const double edge = ground.exemplar.mean_edge;
            if (missing > small_push * edge && (exchange_once(pair.first) || exchange_once(pair.second))) continue;
            push_pair(arrangement, ground, pair, std::min(missing, largest_push * edge));
        }
    }
}

void drop_overlapping(ElementArrangement& arrangement, const GrowthGround& ground) {
    std::vector<ElementPair> pairs = overlapping_pairs_of(arrangement, ground, all_elements(arrangement));
    while (!pairs.empty()) {
        std::map<int, int> overlaps;
        for (const ElementPair& pair : pairs) {
            ++overlaps[pair.first];
            ++overlaps[pair.second];
        }
        const auto goes_first = [&](const auto& x, const auto& y) {
            const ArrangementNode& a = node_of(arrangement, x.first);
            const ArrangementNode& b = node_of(arrangement, y.first);
            if (a.held != b.held) return b.held;
            if (x.second != y.second) return x.second > y.second;
            const double radius_a = ground.exemplar.elements[static_cast<std::size_t>(a.reference)].radius;
            const double radius_b = ground.exemplar.elements[static_cast<std::size_t>(b.reference)].radius;
            return radius_a != radius_b ? radius_a < radius_b : a.birth > b.birth;
        };
        const int gone = std::min_element(overlaps.begin(), overlaps.end(), goes_first)->first;
        remove_node(arrangement, gone);
        std::erase_if(pairs, [&](const ElementPair& pair) { return pair.first == gone || pair.second == gone; });
    }
}

void drop_cut(ElementArrangement& arrangement, const GrowthGround& ground) {
    for (const int element : all_elements(arrangement)) {
        const ArrangementNode& node = node_of(arrangement, element);
        if (!is_cut(ground, node.reference, node.angle, node.position)) continue;
        if (!exchange(arrangement, ground, element)) remove_node(arrangement, element);
    }
}

}  // namespace rinceau
