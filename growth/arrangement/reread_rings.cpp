#include "growth/arrangement/reread_rings.h"

#include <algorithm>
#include <cmath>

#include "growth/arrangement/node_links.h"
#include "growth/arrangement/place_element.h"

namespace rinceau {

namespace {

constexpr double fits = 0.35;              // mean edges
constexpr double misfit_unmatched = 0.75;  // mean edges: farther, no place is matched
constexpr double missing_cost = 0.4;       // of the weight of distance, for each place of a whole ring that stays empty

// The new links; those that were there keep their places. Says which elements have the neighbours they had.
std::vector<char> relink(ElementArrangement& arrangement, const ArrangementMesh& mesh) {
    std::vector<char> unchanged(arrangement.nodes.size(), 0);
    std::vector<std::vector<RingLink>> links(mesh.nodes.size());
    std::vector<int> stray;
    std::vector<std::vector<int>> parents;
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
        const int node = mesh.nodes[i];
        std::size_t known = 0;
        for (const int point : mesh.connectivity.rings[i]) {
            const int other = mesh.nodes[static_cast<std::size_t>(point)];
            const RingLink* old = link_to(arrangement, node, other);
            if (old != nullptr) ++known;
            links[i].push_back(old != nullptr ? *old : RingLink{.other = other});
        }
        // A seed beyond the outermost faces keeps the elements that it was born of.
        if (mesh.connectivity.rings[i].empty() && is_seed(node_of(arrangement, node))) stray.push_back(node);
        const std::size_t had = node_of(arrangement, node).links.size();
        unchanged[static_cast<std::size_t>(node)] = known == links[i].size() && known == had ? 1 : 0;
    }
    for (const int seed : stray) {
        parents.push_back({});
        for (const RingLink& link : node_of(arrangement, seed).links)
            if (is_element(node_of(arrangement, link.other))) parents.back().push_back(link.other);
    }
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) node_of(arrangement, mesh.nodes[i]).links = std::move(links[i]);
    for (std::size_t i = 0; i < stray.size(); ++i)
        for (const int parent : parents[i]) join_nodes(arrangement, stray[i], parent);
    return unchanged;
}

ReferenceMatch best_reading(const ElementArrangement& arrangement, const GrowthGround& ground, RingMatcher& matcher,
                            int element, bool whole) {
    const ArrangementNode& node = arrangement.nodes[static_cast<std::size_t>(element)];
    const TargetRing ring = target_ring(arrangement, ground, element);
    const ReferenceCharges charges(arrangement, ground, node.position, element);
    ReferenceMatch best;
    const auto consider = [&](int reference) {
        const std::size_t places = ground.rings[static_cast<std::size_t>(reference)].offsets.size();
        const double missing = whole && places > ring.inner.size() ? static_cast<double>(places - ring.inner.size()) : 0;
        const double base = charges.of(reference) + missing * missing_cost * ground.options.weights.distance;
        if (!(base < best.cost)) return;
        ReferenceMatch match = matcher.match_near(ring, reference, node.angle, base, best.cost);
        if (match.reference >= 0) best = std::move(match);
    };
    consider(node.reference);
    for (const int reference : ground.usable_of[static_cast<std::size_t>(node.symbol)])
        if (reference != node.reference) consider(reference);
    return best;
}

// Places of the ring for an element that stays as it is.
ReferenceMatch same_reading(const ElementArrangement& arrangement, const GrowthGround& ground, RingMatcher& matcher,
                            int element) {
    const ArrangementNode& node = arrangement.nodes[static_cast<std::size_t>(element)];
    ReferenceMatch match = matcher.match_turned(target_ring(arrangement, ground, element), node.reference, node.angle);
    match.angle = node.angle;
    return match;
}

void reread(ElementArrangement& arrangement, const GrowthGround& ground, const ArrangementMesh& mesh, bool choose) {
    const std::vector<char> unchanged = relink(arrangement, mesh);
    MatchWeights weights = ground.options.weights;
    weights.sub_id = 0;  // neighbours may stay who they are
    RingMatcher matcher(ground, weights);
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
        const int element = mesh.nodes[i];
        ArrangementNode& node = node_of(arrangement, element);
        if (node.reference < 0) continue;
        if (unchanged[static_cast<std::size_t>(element)] != 0 && ring_misfit(arrangement, ground, element) < fits) continue;
        const ReferenceMatch match = choose ? best_reading(arrangement, ground, matcher, element, mesh.connectivity.inner[i])
                                            : same_reading(arrangement, ground, matcher, element);
        const TargetRing ring = target_ring(arrangement, ground, element);
        for (RingLink& link : node.links) link.place = -1;
        if (match.reference < 0) continue;
        node.reference = match.reference;
        node.angle = match.angle;
        for (std::size_t k = 0; k < ring.inner.size(); ++k)
            if (match.places[k] >= 0) fill_place(arrangement, ground, element, ring.inner[k].node, match.places[k]);
    }
}

}  // namespace

double ring_misfit(const ElementArrangement& arrangement, const GrowthGround& ground, int element) {
    const ArrangementNode& node = arrangement.nodes[static_cast<std::size_t>(element)];
    if (node.links.empty()) return 0;
    double sum = 0;
    for (const RingLink& link : node.links) {
        const Point offset = arrangement.nodes[static_cast<std::size_t>(link.other)].position - node.position;
        sum += link.place >= 0 ? norm(offset - link.target) : std::pow(misfit_unmatched * ground.exemplar.mean_edge, 2);
    }
    return std::sqrt(sum / static_cast<double>(node.links.size())) / ground.exemplar.mean_edge;
}

void reread_rings(ElementArrangement& arrangement, const GrowthGround& ground, const ArrangementMesh& mesh) {
    reread(arrangement, ground, mesh, true);
}

void relink_rings(ElementArrangement& arrangement, const GrowthGround& ground, const ArrangementMesh& mesh) {
    reread(arrangement, ground, mesh, false);
}

}  // namespace rinceau
