// Ijiri et al. 2008, sections 5.2 and 5.3. Deviations:
// - Distances count in mean edges l: the weights of eq. 2 have no unit, so that the drawing's scale would change their
// ratio.
// - By default a neighbour takes the nearest place of the ring and may stay without one (as Barla et al. 2006 do); the
//   paper's cyclic orders without skips make false pairs as soon as one neighbour is missing or one too many.
// - The paper starts a ring "at the boundary", which a seed between several fronts has not: here it starts after the largest
// gap.
#include "growth/arrangement/match_ring.h"

#include <algorithm>
#include <cmath>

#include "geometry/angle.h"

namespace rinceau {

namespace {

constexpr double farthest_pair = 0.75;  // in mean edges: farther places are not the neighbour's
constexpr double fit_gain = 0.2;        // in mean edges: a fitted turn seldom brings a neighbour nearer by more
constexpr double turn_weight =
    0.1;  // against a ring that is turned otherwise than its neighbours, of the weight of distance
constexpr double outer_weight = 0.5;  // of the second ring against the first

RingNeighbor neighbor_of(const ElementArrangement& arrangement, const GrowthGround& ground, int node, int other) {
    const ArrangementNode& center = node_of(arrangement, node);
    const ArrangementNode& neighbor = node_of(arrangement, other);
    RingNeighbor result;
    result.node = other;
    result.offset = neighbor.position - center.position;
    result.symbol = neighbor.symbol;
    if (neighbor.reference >= 0)
        result.sub_id = ground.exemplar.elements[static_cast<std::size_t>(neighbor.reference)].sub_id;
    result.step = {neighbor.lattice[0] - center.lattice[0], neighbor.lattice[1] - center.lattice[1]};
    return result;
}

// Counter-clockwise, from the far side of the largest gap.
void order_ring(std::vector<RingNeighbor>& ring) {
    std::vector<std::pair<double, std::size_t>> angles;
    for (std::size_t i = 0; i < ring.size(); ++i) angles.push_back({arg(ring[i].offset), i});
    std::sort(angles.begin(), angles.end());
    std::size_t first = 0;
    double largest = -1;
    for (std::size_t i = 0; i < angles.size(); ++i) {
        const double before = i > 0 ? angles[i - 1].first : angles.back().first - two_pi;
        if (angles[i].first - before > largest) {
            largest = angles[i].first - before;
            first = i;
        }
    }
    std::vector<RingNeighbor> ordered;
    for (std::size_t i = 0; i < angles.size(); ++i) ordered.push_back(ring[angles[(first + i) % angles.size()].second]);
    ring = std::move(ordered);
}

void add_outer(const ElementArrangement& arrangement, const GrowthGround& ground, int node, TargetRing& ring) {
    std::vector<int> known{node};
    for (const RingNeighbor& neighbor : ring.inner) known.push_back(neighbor.node);
    const std::size_t inner = known.size();
    for (std::size_t i = 1; i < inner; ++i) {
        for (const RingLink& link : node_of(arrangement, known[i]).links) {
            if (std::find(known.begin(), known.end(), link.other) != known.end()) continue;
            known.push_back(link.other);
            ring.outer.push_back(neighbor_of(arrangement, ground, node, link.other));
        }
    }
}

}  // namespace

TargetRing ring_of_nodes(const ElementArrangement& arrangement, const GrowthGround& ground, int node,
                         const std::vector<int>& others) {
    TargetRing ring;
    for (const int other : others) ring.inner.push_back(neighbor_of(arrangement, ground, node, other));
    order_ring(ring.inner);
    if (ground.options.two_rings) add_outer(arrangement, ground, node, ring);
    return ring;
}

TargetRing target_ring(const ElementArrangement& arrangement, const GrowthGround& ground, int node) {
    std::vector<int> others;
    for (const RingLink& link : node_of(arrangement, node).links) others.push_back(link.other);
    return ring_of_nodes(arrangement, ground, node, others);
}

void RingMatcher::turn_places(const ReferenceRing& ring, Complex turn) {
    turned_.resize(ring.offsets.size());
    for (std::size_t k = 0; k < turned_.size(); ++k) turned_[k] = turn * ring.offsets[k];
}

double RingMatcher::pair_cost(const RingNeighbor& neighbor, const ReferenceRing& ring, std::size_t place) const {
    double cost = weights_.distance * abs(neighbor.offset - turned_[place]) / ground_.exemplar.mean_edge;
    if (neighbor.symbol >= 0 && neighbor.symbol != ring.symbols[place]) cost += weights_.symbol;
    if (neighbor.sub_id >= 0 && neighbor.sub_id == ring.sub_ids[place]) cost += weights_.sub_id;
    return cost;
}

double RingMatcher::unmatched_cost() const { return farthest_pair * weights_.distance + weights_.symbol; }

double RingMatcher::match_nearest(const TargetRing& target, const ReferenceRing& ring, double base, double limit) {
    const double farthest = std::pow(farthest_pair * ground_.exemplar.mean_edge, 2);
    taken_.assign(turned_.size(), 0);
    places_.assign(target.inner.size(), -1);
    double cost = base;
    for (std::size_t i = 0; i < target.inner.size() && cost < limit; ++i) {
        double nearest = farthest;
        for (std::size_t k = 0; k < turned_.size(); ++k) {
            const double distance = norm(target.inner[i].offset - turned_[k]);
            if (taken_[k] != 0 || !(distance < nearest)) continue;
            nearest = distance;
            places_[i] = static_cast<int>(k);
        }
        if (places_[i] < 0) {
            cost += unmatched_cost();
            continue;
        }
        taken_[static_cast<std::size_t>(places_[i])] = 1;
        cost += pair_cost(target.inner[i], ring, static_cast<std::size_t>(places_[i]));
    }
    return cost;
}

// On a lattice the sites say which place is whose, however far the elements are off them.
double RingMatcher::match_sites(const TargetRing& target, int reference, double base, double limit) {
    const ReferenceRing& ring = ground_.rings[static_cast<std::size_t>(reference)];
    places_.assign(target.inner.size(), -1);
    double cost = base;
    for (std::size_t i = 0; i < target.inner.size() && cost < limit; ++i) {
        for (std::size_t k = 0; k < ring.offsets.size(); ++k)
            if (ring.steps[k] == target.inner[i].step) places_[i] = static_cast<int>(k);
        cost += places_[i] < 0 ? unmatched_cost() : pair_cost(target.inner[i], ring, static_cast<std::size_t>(places_[i]));
    }
    return cost;
}

double RingMatcher::match_in_order(const TargetRing& target, const ReferenceRing& ring, std::size_t first, double base,
                                   double limit) {
    places_.assign(target.inner.size(), -1);
    double cost = base;
    for (std::size_t i = 0; i < target.inner.size() && cost < limit; ++i) {
        const std::size_t place = (first + i) % turned_.size();
        places_[i] = static_cast<int>(place);
        cost += pair_cost(target.inner[i], ring, place);
    }
    return cost;
}

double RingMatcher::outer_cost(const TargetRing& target, const ReferenceRing& ring, Complex turn, double cost,
                               double limit) const {
    const double farthest = std::pow(farthest_pair * ground_.exemplar.mean_edge, 2);
    for (std::size_t i = 0; i < target.outer.size() && cost < limit; ++i) {
        const RingNeighbor& neighbor = target.outer[i];
        double nearest = farthest;
        int symbol = -1;
        for (std::size_t k = 0; k < ring.outer_offsets.size(); ++k) {
            const double distance = norm(neighbor.offset - turn * ring.outer_offsets[k]);
            if (!(distance < nearest)) continue;
            nearest = distance;
            symbol = ring.outer_symbols[k];
        }
        const bool differs = symbol < 0 || (neighbor.symbol >= 0 && neighbor.symbol != symbol);
        cost += outer_weight *
                (weights_.distance * std::sqrt(nearest) / ground_.exemplar.mean_edge + (differs ? weights_.symbol : 0));
    }
    return cost;
}

// Eq. 4 by shape matching (Mueller et al. 2005): the turn that brings the matched places nearest to the neighbours.
Complex RingMatcher::fitted_turn(const TargetRing& target, const ReferenceRing& ring, Complex otherwise) const {
    Complex sum;
    for (std::size_t i = 0; i < target.inner.size(); ++i)
        if (places_[i] >= 0) sum += conj(ring.offsets[static_cast<std::size_t>(places_[i])]) * target.inner[i].offset;
    const double length = abs(sum);
    return length > 0 ? sum / length : otherwise;
}

void RingMatcher::keep(ReferenceMatch& best, int reference, Complex turn, double cost) {
    if (!(cost < best.cost)) return;
    best.reference = reference;
    best.angle = arg(turn);
    best.cost = cost;
    best.places.swap(places_);  // the room of either is used again
}

void RingMatcher::try_turn(const TargetRing& target, int reference, Complex turn, double base, double limit,
                           ReferenceMatch& best) {
    const ReferenceRing& ring = ground_.rings[static_cast<std::size_t>(reference)];
    turn_places(ring, turn);
    const double cost =
        ground_.by_lattice ? match_sites(target, reference, base, limit) : match_nearest(target, ring, base, limit);
    const double total = outer_cost(target, ring, turn, cost, limit);
    if (total < limit) keep(best, reference, turn, total);
}

void RingMatcher::try_shifts(const TargetRing& target, int reference, Complex turn, double base, double limit,
                             ReferenceMatch& best) {
    const ReferenceRing& ring = ground_.rings[static_cast<std::size_t>(reference)];
    if (target.inner.size() > ring.offsets.size()) return;
    const double no_limit = std::numeric_limits<double>::infinity();
    const bool turns = ground_.options.mode == RotationMode::rotate;
    for (std::size_t first = 0; first < ring.offsets.size(); ++first) {
        turn_places(ring, turn);
        if (turns) {
            match_in_order(target, ring, first, base, no_limit);
            turn = fitted_turn(target, ring, turn);
            turn_places(ring, turn);
        }
        const double bound = std::min(limit, best.cost);
        const double cost = outer_cost(target, ring, turn, match_in_order(target, ring, first, base, bound), bound);
        if (cost < bound) keep(best, reference, turn, cost);
    }
}

ReferenceMatch RingMatcher::match(const TargetRing& ring, int reference, double angle, double base, double limit) {
    ReferenceMatch best;
    const ReferenceRing& places = ground_.rings[static_cast<std::size_t>(reference)];
    if (ground_.options.matching == RingMatching::cyclic) {
        try_shifts(ring, reference, polar(1, angle), base, limit, best);
    } else if (ground_.options.mode != RotationMode::rotate || ring.inner.empty()) {
        try_turn(ring, reference, polar(1, angle), base, limit, best);
    } else {
        // The first neighbour on each place in turn; then the angle that suits all.
        const Point first = ring.inner.front().offset;
        for (std::size_t k = 0; k < places.offsets.size(); ++k) {
            const Complex turn = first / places.offsets[k];
            const double length = abs(turn);
            if (!(length > 0)) continue;
            const double bound = std::min(limit, best.cost);
            const double worth_fitting = bound + fit_gain * weights_.distance * static_cast<double>(ring.inner.size());
            turn_places(places, turn / length);
            if (!(match_nearest(ring, places, base, worth_fitting) < worth_fitting)) continue;
            const Complex fitted = fitted_turn(ring, places, turn / length);
            const double against = turn_weight * weights_.distance * (1 - dot(fitted, polar(1, angle)));
            try_turn(ring, reference, fitted, base + against, bound, best);
        }
    }
    return best;
}

ReferenceMatch RingMatcher::match_near(const TargetRing& ring, int reference, double angle, double base, double limit) {
    ReferenceMatch best;
    const ReferenceRing& places = ground_.rings[static_cast<std::size_t>(reference)];
    Complex turn = polar(1, angle);
    if (ground_.options.mode == RotationMode::rotate) {
        turn_places(places, turn);
        match_nearest(ring, places, base, std::numeric_limits<double>::infinity());
        turn = fitted_turn(ring, places, turn);
    }
    try_turn(ring, reference, turn, base, limit, best);
    return best;
}

ReferenceMatch RingMatcher::match_turned(const TargetRing& ring, int reference, double angle) {
    ReferenceMatch best;
    try_turn(ring, reference, polar(1, angle), 0, std::numeric_limits<double>::infinity(), best);
    return best;
}

}  // namespace rinceau
