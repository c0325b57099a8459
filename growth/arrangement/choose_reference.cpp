// Ijiri et al. 2008, eq. 1, with two charges that the paper has not. Its term for sub-ids forbids the same two elements side
// by side; that one element of the drawing stands in rows, which a viewer sees first, it does not see (repeat). And where
// rare elements fit worse than common ones their share falls with every step (balance).
#include "growth/arrangement/choose_reference.h"

#include <algorithm>
#include <cmath>

#include "growth/arrangement/node_links.h"

namespace rinceau {

namespace {

constexpr double repeat_near = 1.4;       // in mean edges: copies up to here count once,
constexpr double repeat_far = 2.6;        // up to here half
constexpr std::size_t balance_from = 30;  // elements: shares of fewer are chance
constexpr double same_cost = 1e-9;        // costs that differ less are the same but for rounding

}  // namespace

ReferenceCharges::ReferenceCharges(const ElementArrangement& arrangement, const GrowthGround& ground, Point at, int except)
    : ground_(ground), weights_(ground.options.weights) {
    const Exemplar& exemplar = ground.exemplar;
    if (weights_.repeat != 0) {
        repeats_.assign(static_cast<std::size_t>(ground.sub_ids), 0);
        const double near = repeat_near * exemplar.mean_edge;
        arrangement.grid.visit(at, repeat_far * exemplar.mean_edge, [&](int node, Point position) {
            const int reference = node_of(arrangement, node).reference;
            if (reference < 0 || node == except) return;
            const int sub_id = exemplar.elements[static_cast<std::size_t>(reference)].sub_id;
            repeats_[static_cast<std::size_t>(sub_id)] += norm(position - at) < near * near ? 1 : 0.5;
        });
    }
    if (weights_.balance != 0 && arrangement.elements >= balance_from) {
        for (std::size_t symbol = 0; symbol < exemplar.symbols.size(); ++symbol) {
            const double share = static_cast<double>(arrangement.counts[symbol]) / static_cast<double>(arrangement.elements);
            const double wanted = std::max(exemplar.symbols[symbol].share, 1e-9);
            surplus_.push_back(std::clamp(share / wanted - 1, -1.0, 1.0));
        }
    }
}

double ReferenceCharges::of(int reference) const {
    const ExemplarElement& element = ground_.exemplar.elements[static_cast<std::size_t>(reference)];
    double charge = 0;
    if (!repeats_.empty()) charge += weights_.repeat * repeats_[static_cast<std::size_t>(element.sub_id)];
    if (!surplus_.empty()) {
        const std::vector<int>& symbols = ground_.rings[static_cast<std::size_t>(reference)].symbols;
        double sum = 0;
        for (const int symbol : symbols) sum += surplus_[static_cast<std::size_t>(symbol)];
        charge += weights_.balance * (2 * surplus_[static_cast<std::size_t>(element.symbol)] +
                                      sum / static_cast<double>(std::max<std::size_t>(symbols.size(), 1)));
    }
    return charge;
}

namespace {

const std::vector<int>& candidates_for(const GrowthGround& ground, int symbol) {
    if (symbol < 0 || ground.usable_of[static_cast<std::size_t>(symbol)].empty()) return ground.usable;
    return ground.usable_of[static_cast<std::size_t>(symbol)];
}

// Where no angle is given the seed goes the way of its neighbours: in mode rotate a ring that fits several ways is turned as
// theirs are, and of a flow without forward and back one of both directions is theirs.
double seed_angle(const ElementArrangement& arrangement, const GrowthGround& ground, int seed) {
    Complex hint;
    for (const RingLink& link : node_of(arrangement, seed).links)
        if (node_of(arrangement, link.other).reference >= 0) hint += polar(1, node_of(arrangement, link.other).angle);
    if (ground.options.mode == RotationMode::rotate) return arg(hint);
    return ring_angle(ground, node_of(arrangement, seed).position, hint);
}

// The candidates in the order of trying: first what the exemplar has there in the neighbours' eyes, which mostly fits, so
// that others are soon seen to cost more; then all from a random one on.
std::vector<int> trial_order(const ElementArrangement& arrangement, const GrowthGround& ground, int seed,
                             const std::vector<int>& candidates, Random& random) {
    std::vector<int> order;
    const int symbol = candidates.size() == ground.usable.size()
                           ? -1
                           : ground.exemplar.elements[static_cast<std::size_t>(candidates.front())].symbol;
    for (const RingLink& link : node_of(arrangement, seed).links) {
        const RingLink* back = link_to(arrangement, link.other, seed);
        if (back->place < 0) continue;
        const int parent = node_of(arrangement, link.other).reference;
        const int wanted =
            ground.exemplar.elements[static_cast<std::size_t>(parent)].ring.elements[static_cast<std::size_t>(back->place)];
        const ExemplarElement& element = ground.exemplar.elements[static_cast<std::size_t>(wanted)];
        if (element.usable && (symbol < 0 || element.symbol == symbol)) order.push_back(wanted);
    }
    const std::size_t first = random.below(static_cast<std::uint32_t>(candidates.size()));
    for (std::size_t i = 0; i < candidates.size(); ++i) order.push_back(candidates[(first + i) % candidates.size()]);
    return order;
}

// Keeps the cheapest; `base` and `match` as RingMatcher::match has them.
template <class Match>
ReferenceMatch cheapest(const std::vector<int>& candidates, const ReferenceCharges& charges, Match&& match) {
    ReferenceMatch best;
    for (const int reference : candidates) {
        const double base = charges.of(reference);
        const double limit = best.cost - same_cost;
        if (!(base < limit)) continue;
        ReferenceMatch found = match(reference, base, limit);
        if (found.reference >= 0) best = std::move(found);
    }
    return best;
}

}  // namespace

ReferenceMatch best_reference(const ElementArrangement& arrangement, const GrowthGround& ground, RingMatcher& matcher,
                              int seed, const TargetRing& ring, Random& random) {
    const ArrangementNode& node = node_of(arrangement, seed);
    const std::vector<int> candidates = trial_order(arrangement, ground, seed, candidates_for(ground, node.symbol), random);
    const ReferenceCharges charges(arrangement, ground, node.position, seed);
    const double angle = seed_angle(arrangement, ground, seed);
    ReferenceMatch best = cheapest(candidates, charges, [&](int reference, double base, double limit) {
        return matcher.match(ring, reference, angle, base, limit);
    });
    // More neighbours than any ring has places: no cyclic order takes them, but some of them can be matched.
    if (best.reference < 0)
        best = cheapest(candidates, charges, [&](int reference, double base, double limit) {
            return matcher.match_near(ring, reference, angle, base, limit);
        });
    return best;
}

std::vector<ReferenceMatch> references_by_cost(const ElementArrangement& arrangement, const GrowthGround& ground,
                                               RingMatcher& matcher, int seed, const TargetRing& ring) {
    const ArrangementNode& node = node_of(arrangement, seed);
    const ReferenceCharges charges(arrangement, ground, node.position, seed);
    const double angle = seed_angle(arrangement, ground, seed);
    std::vector<ReferenceMatch> matches;
    for (const int reference : candidates_for(ground, node.symbol)) {
        ReferenceMatch match =
            matcher.match(ring, reference, angle, charges.of(reference), std::numeric_limits<double>::infinity());
        if (match.reference >= 0) matches.push_back(std::move(match));
    }
    std::stable_sort(matches.begin(), matches.end(),
                     [](const ReferenceMatch& a, const ReferenceMatch& b) { return a.cost < b.cost; });
    return matches;
}

}  // namespace rinceau
