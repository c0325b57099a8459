// Topological order (Kahn 1962) with a heap by place; of a circle of wishes the first by place is freed.
#include "growth/arrangement/paint_order.h"

#include <algorithm>
#include <functional>
#include <queue>
#include <utility>

#include "growth/arrangement/grow_arrangement.h"

namespace rinceau {

namespace {

/// The direction in which the exemplar goes on painting: from what is painted first to its neighbours that are painted later.
Point painting_direction(const Exemplar& exemplar) {
    Point sum;
    for (std::size_t i = 0; i < exemplar.elements.size(); ++i) {
        const ExemplarRing& ring = exemplar.elements[i].ring;
        for (std::size_t k = 0; k < ring.elements.size(); ++k)
            if (exemplar.elements[static_cast<std::size_t>(ring.elements[k])].sub_id > exemplar.elements[i].sub_id) sum += ring.offsets[k];
    }
    return norm(sum) > 0 ? sum / abs(sum) : Point{0, -1};  // as text is written: from above
}

/// How much more often the first of two neighbours wants to be painted before the second than after it.
int votes_for_before(const ElementArrangement& arrangement, const Exemplar& exemplar, int node, const RingLink& link) {
    const auto vote = [&](int from, const RingLink& to) {
        if (to.place < 0) return 0;
        const ExemplarElement& own = exemplar.elements[static_cast<std::size_t>(arrangement.nodes[static_cast<std::size_t>(from)].reference)];
        const int other = own.ring.elements[static_cast<std::size_t>(to.place)];
        const int later_by = exemplar.elements[static_cast<std::size_t>(other)].sub_id - own.sub_id;
        return later_by > 0 ? 1 : later_by < 0 ? -1 : 0;  // copies in a tile have no order
    };
    int votes = vote(node, link);
    for (const RingLink& back : arrangement.nodes[static_cast<std::size_t>(link.other)].links)
        if (back.other == node) votes -= vote(link.other, back);
    return votes;
}

}  // namespace

std::vector<int> paint_order(const ElementArrangement& arrangement, const Exemplar& exemplar) {
    const std::vector<int> nodes = nodes_by_birth(arrangement);
    std::vector<int> place(arrangement.nodes.size(), -1);
    for (std::size_t i = 0; i < nodes.size(); ++i) place[static_cast<std::size_t>(nodes[i])] = static_cast<int>(i);
    // Who must wait for whom.
    std::vector<std::vector<int>> later(nodes.size());
    std::vector<int> waits_for(nodes.size(), 0);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        for (const RingLink& link : arrangement.nodes[static_cast<std::size_t>(nodes[i])].links) {
            const int other = place[static_cast<std::size_t>(link.other)];
            if (other < 0 || votes_for_before(arrangement, exemplar, nodes[i], link) <= 0) continue;
            later[i].push_back(other);
            ++waits_for[static_cast<std::size_t>(other)];
        }
    }
    const Point direction = painting_direction(exemplar);
    using Candidate = std::pair<double, int>;
    std::vector<Candidate> by_place;
    for (std::size_t i = 0; i < nodes.size(); ++i)
        by_place.push_back({dot(arrangement.nodes[static_cast<std::size_t>(nodes[i])].position, direction), static_cast<int>(i)});
    std::sort(by_place.begin(), by_place.end());
    std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> free;
    std::vector<char> queued(nodes.size(), 0);
    const auto release = [&](const Candidate& candidate) {
        if (std::exchange(queued[static_cast<std::size_t>(candidate.second)], 1) == 0) free.push(candidate);
    };
    std::vector<double> along(nodes.size());
    for (const Candidate& candidate : by_place) {
        along[static_cast<std::size_t>(candidate.second)] = candidate.first;
        if (waits_for[static_cast<std::size_t>(candidate.second)] == 0) release(candidate);
    }
    std::vector<int> order;
    for (std::size_t next = 0; order.size() < nodes.size();) {
        // A circle: the first by place that is still waiting.
        while (free.empty()) release(by_place[next++]);
        const int painted = free.top().second;
        free.pop();
        order.push_back(painted);
        for (const int other : later[static_cast<std::size_t>(painted)])
            if (--waits_for[static_cast<std::size_t>(other)] == 0) release({along[static_cast<std::size_t>(other)], other});
    }
    return order;
}

}  // namespace rinceau
