// Ijiri et al. 2008, section 5: the loop. docs/growth.md lists what differs from the paper.
#include "growth/arrangement/grow_arrangement.h"

#include <algorithm>
#include <cmath>

#include "geometry/angle.h"
#include "growth/arrangement/node_links.h"
#include "growth/arrangement/outline_contact.h"
#include "growth/arrangement/place_element.h"
#include "growth/arrangement/settle_arrangement.h"
#include "growth/arrangement/stay_inside.h"

namespace rinceau {

namespace {

constexpr std::size_t tries_at_lines = 12;        // references that are tried where a line cuts the best one
constexpr std::size_t relax_all_from = 16;        // elements: fewer are all near each other
constexpr std::size_t most_elements = 1'000'000;  // of a growth that nothing else ends
constexpr double priority_reach = 5;              // mean edges (section 5.1)
constexpr std::size_t relax_all_growth =
    4;  // the whole is relaxed whenever it has grown so many times: oftener is no better
constexpr int angle_rounds = 2;
constexpr std::size_t report_every = 64;  // steps

/// One call of grow().
class Growing {
  public:
    Growing(ElementArrangement arrangement, const Exemplar& exemplar, const ArrangeSurroundings& around,
            const GrowOrder& order)
        : arrangement_(std::move(arrangement)),
          ground_(make_ground(exemplar, around, arrangement_.options)),
          matcher_(ground_, ground_.options.weights),
          order_(order) {}

    ElementArrangement run(const Progress& progress);

  private:
    SeedQueue& queue() { return order_.brush ? below_brush_ : arrangement_.queue; }
    bool is_below_brush(Point p) const { return !order_.brush || abs(p - order_.brush->center) <= order_.brush->radius; }
    void collect_below_brush();
    void enqueue(int seed);
    void release(int node);
    int priority(int symbol) const;
    std::optional<int> blocking_seed(int seed) const;
    bool place_seed(int seed);
    void grow_seed(int seed);

    ElementArrangement arrangement_;
    GrowthGround ground_;
    RingMatcher matcher_;
    const GrowOrder& order_;
    SeedQueue below_brush_;
};

// The most elements that the order can mean: what fits into an area, with much to spare.
std::size_t largest_count(const ElementArrangement& arrangement, const GrowthGround& ground, const GrowOrder& order) {
    constexpr double spare = 4;
    std::size_t most = std::min(order.count, arrangement.elements + most_elements);
    const auto fits = [&](double area_to_fill) {
        return arrangement.elements + 100 +
               static_cast<std::size_t>(std::min(spare * area_to_fill * ground.exemplar.density, 1e9));
    };
    if (order.brush) most = std::min(most, fits(pi * std::pow(order.brush->radius + ground.exemplar.mean_edge, 2)));
    if (ground.around.boundary != nullptr && ground.around.boundary->region())
        most = std::min(most, fits(area(*ground.around.boundary->region())));
    return most;
}

int Growing::priority(int symbol) const {
    const std::vector<int>& priorities = ground_.options.priorities;
    if (priorities.empty()) return 0;
    // A seed of any kind waits for all that have one.
    if (symbol < 0) return *std::min_element(priorities.begin(), priorities.end());
    return static_cast<std::size_t>(symbol) < priorities.size() ? priorities[static_cast<std::size_t>(symbol)] : 0;
}

void Growing::enqueue(int seed) {
    const Point at = node_of(arrangement_, seed).position;
    arrangement_.queue.push({abs(at - *arrangement_.start), seed});
    if (order_.brush && is_below_brush(at)) below_brush_.push({abs(at - order_.brush->center), seed});
}

void Growing::release(int node) {
    arrangement_.queue.release(node);
    below_brush_.release(node);
}

void Growing::collect_below_brush() {
    if (!order_.brush) return;
    arrangement_.grid.visit(order_.brush->center, order_.brush->radius, [&](int node, Point position) {
        if (is_seed(node_of(arrangement_, node))) below_brush_.push({abs(position - order_.brush->center), node});
    });
}

// Section 5.1: the nearest seed of higher priority within 5 l.
std::optional<int> Growing::blocking_seed(int seed) const {
    if (ground_.options.priorities.empty()) return std::nullopt;
    const Point at = arrangement_.nodes[static_cast<std::size_t>(seed)].position;
    const int own = priority(arrangement_.nodes[static_cast<std::size_t>(seed)].symbol);
    std::optional<int> best;
    double best_distance = 0;
    arrangement_.grid.visit(at, priority_reach * ground_.exemplar.mean_edge, [&](int node, Point position) {
        const ArrangementNode& other = arrangement_.nodes[static_cast<std::size_t>(node)];
        if (!is_seed(other) || priority(other.symbol) <= own || !is_below_brush(position)) return;
        const double distance = norm(position - at);
        if (best && (distance > best_distance || (distance == best_distance && node > *best))) return;
        best = node;
        best_distance = distance;
    });
    return best;
}

// False if nothing fits there.
bool Growing::place_seed(int seed) {
    const TargetRing ring = target_ring(arrangement_, ground_, seed);
    const auto place = [&](const ReferenceMatch& match) {
        const Point wanted = fitted_position(arrangement_, ground_, seed, ring, match);
        const Point inside = pushed_inside(ground_, match.reference, match.angle, wanted);
        if (inside != wanted && is_crowded(arrangement_, ground_, seed, match.reference, inside)) return false;
        const std::optional<Point> free = free_position(arrangement_, ground_, {match.reference, inside, match.angle}, seed);
        if (!free) return false;
        const Point at = *free;
        if (is_cut(ground_, match.reference, match.angle, at)) return false;
        for (const int born : place_element(arrangement_, ground_, seed, ring, match, at)) enqueue(born);
        return true;
    };
    const ReferenceMatch best = best_reference(arrangement_, ground_, matcher_, seed, ring, arrangement_.random);
    if (best.reference < 0) return false;
    if (place(best)) return true;
    const std::vector<ReferenceMatch> others = references_by_cost(arrangement_, ground_, matcher_, seed, ring);
    for (std::size_t i = 0; i < std::min(others.size(), tries_at_lines); ++i)
        if (place(others[i])) return true;
    return false;
}

void Growing::grow_seed(int seed) {
    if (!place_seed(seed)) {
        remove_node(arrangement_, seed);
        below_brush_.release(seed);
        return;
    }
    release(seed);
    if (!ground_.options.relax) return;
    settle_near(arrangement_, ground_, seed);
    if (arrangement_.elements < relax_all_growth * std::max(arrangement_.relaxed, relax_all_from)) return;
    settle_all(arrangement_, ground_, angle_rounds);
    arrangement_.relaxed = arrangement_.elements;
}

ElementArrangement Growing::run(const Progress& progress) {
    collect_below_brush();
    const std::size_t most = largest_count(arrangement_, ground_, order_);
    const std::size_t stood = arrangement_.elements;
    for (std::size_t step = 0; arrangement_.elements < most; ++step) {
        if (order_.stop && order_.stop()) break;
        if (step % report_every == 0)
            report(progress, "grow", static_cast<double>(arrangement_.elements - stood) / static_cast<double>(most - stood));
        const std::optional<QueuedSeed> next = queue().pop();
        if (!next) break;
        if (!is_seed(node_of(arrangement_, next->node))) continue;
        if (const std::optional<int> blocker = blocking_seed(next->node))
            queue().wait(*next, *blocker);
        else
            grow_seed(next->node);
    }
    return std::move(arrangement_);
}

// The lattice site that is nearest, so that what grows there meets what stands.
struct SeedPlace {
    Point at;
    std::array<int, 2> site{};
};
SeedPlace nearest_site(const ElementArrangement& arrangement, const ExemplarLattice& lattice, Point at) {
    const Point off = at - *arrangement.start;
    const double turn = cross(lattice.basis[0], lattice.basis[1]);
    const std::array<int, 2> site{static_cast<int>(std::lround(cross(off, lattice.basis[1]) / turn)),
                                  static_cast<int>(std::lround(cross(lattice.basis[0], off) / turn))};
    return {*arrangement.start + site[0] * lattice.basis[0] + site[1] * lattice.basis[1], site};
}

}  // namespace

ElementArrangement empty_arrangement(const Exemplar& exemplar, const ArrangeOptions& options) {
    ElementArrangement arrangement;
    arrangement.options = options;
    arrangement.random = Random(options.seed);
    arrangement.grid = NodeGrid(exemplar.mean_edge);
    arrangement.counts.assign(exemplar.symbols.size(), 0);
    return arrangement;
}

ElementArrangement with_seed(ElementArrangement arrangement, const Exemplar& exemplar, const ArrangeSurroundings& around,
                             Point at) {
    const GrowthGround ground = make_ground(exemplar, around, arrangement.options);
    SeedPlace place{at};
    const bool first = !arrangement.start;
    if (!first && ground.by_lattice) place = nearest_site(arrangement, *exemplar.lattice, at);
    if (is_barred(ground, place.at, place.at)) return arrangement;
    if (nearest_node(arrangement, place.at, exemplar.mean_edge, -1)) return arrangement;
    if (first) arrangement.start = at;
    const int seed = add_seed(arrangement, place.at, -1);
    node_of(arrangement, seed).lattice = place.site;
    node_of(arrangement, seed).held = first;
    if (ground.by_lattice) arrangement.sites.set(site_key(place.site), seed);
    arrangement.queue.push({abs(place.at - *arrangement.start), seed});
    return arrangement;
}

ElementArrangement grow(ElementArrangement arrangement, const Exemplar& exemplar, const ArrangeSurroundings& around,
                        const GrowOrder& order, const Progress& progress) {
    return Growing(std::move(arrangement), exemplar, around, order).run(progress);
}

std::vector<int> nodes_by_birth(const ElementArrangement& arrangement) {
    std::vector<int> nodes;
    for (std::size_t i = 0; i < arrangement.nodes.size(); ++i)
        if (is_element(arrangement.nodes[i])) nodes.push_back(static_cast<int>(i));
    std::sort(nodes.begin(), nodes.end(), [&](int a, int b) {
        return arrangement.nodes[static_cast<std::size_t>(a)].birth < arrangement.nodes[static_cast<std::size_t>(b)].birth;
    });
    return nodes;
}

std::vector<ArrangedElement> arranged_elements(const ElementArrangement& arrangement) {
    std::vector<ArrangedElement> elements;
    for (const int index : nodes_by_birth(arrangement)) {
        const ArrangementNode& node = arrangement.nodes[static_cast<std::size_t>(index)];
        elements.push_back({node.reference, node.position, node.angle});
    }
    return elements;
}

std::vector<std::pair<int, int>> arranged_edges(const ElementArrangement& arrangement) {
    const std::vector<int> nodes = nodes_by_birth(arrangement);
    std::vector<int> place(arrangement.nodes.size(), -1);
    for (std::size_t i = 0; i < nodes.size(); ++i) place[static_cast<std::size_t>(nodes[i])] = static_cast<int>(i);
    std::vector<std::pair<int, int>> edges;
    for (std::size_t i = 0; i < nodes.size(); ++i)
        for (const RingLink& link : arrangement.nodes[static_cast<std::size_t>(nodes[i])].links)
            if (place[static_cast<std::size_t>(link.other)] > static_cast<int>(i))
                edges.push_back({static_cast<int>(i), place[static_cast<std::size_t>(link.other)]});
    return edges;
}

}  // namespace rinceau
