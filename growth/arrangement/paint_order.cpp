// Not in Ijiri et al. 2008, whose elements are painted as they are placed: scales and feathers then lie over one another at
// random.

#include "growth/arrangement/paint_order.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

#include "geometry/box_tree.h"
#include "geometry/kd_tree.h"

namespace rinceau {
namespace {

/// What the exemplar says of an element's neighbours.
class OverlapExample {
  public:
    explicit OverlapExample(const Exemplar& exemplar) : exemplar_(exemplar), tree_(positions(exemplar)) {}

    /// Above 0 if a neighbour there lies above the element, below 0 if below; the surer, the farther from 0.
    double neighbor_above(const ArrangedElement& element, Point neighbor) const {
        const auto self = static_cast<std::size_t>(element.reference);
        const Point offset = polar(1, -element.angle) * (neighbor - element.position);
        const Point wanted = exemplar_.elements[self].position + offset;
        constexpr double reach = 0.5;  // mean edges: beyond, the exemplar has no neighbour there
        double best = reach * exemplar_.mean_edge;
        std::size_t found = self;
        for (const Neighbor& other : tree_.within(wanted, best)) {
            const double miss = abs(exemplar_.elements[other.index].position - wanted);
            if (other.index == self || miss >= best) continue;
            best = miss;
            found = other.index;
        }
        const std::size_t own = self % exemplar_.originals, theirs = found % exemplar_.originals;
        const double sureness = 1 - best / (reach * exemplar_.mean_edge);
        return theirs == own ? 0 : (theirs > own ? sureness : -sureness);
    }

  private:
    static std::vector<Point> positions(const Exemplar& exemplar) {
        std::vector<Point> all;
        for (const ExemplarElement& element : exemplar.elements) all.push_back(element.position);
        return all;
    }

    const Exemplar& exemplar_;
    KdTree tree_;
};

/// below -> above, by index.
using OverlapEdges = std::vector<std::vector<std::size_t>>;

OverlapEdges overlap_edges(const Exemplar& exemplar, const std::vector<ArrangedElement>& elements) {
    const auto radius = [&](std::size_t i) {
        return exemplar.elements[static_cast<std::size_t>(elements[i].reference)].radius;
    };
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < elements.size(); ++i)
        boxes.push_back(grown(Box{elements[i].position, elements[i].position}, radius(i)));
    const BoxTree tree(boxes);
    const OverlapExample example(exemplar);
    OverlapEdges above(elements.size());
    for (std::size_t i = 0; i < elements.size(); ++i) {
        tree.visit(boxes[i], [&](std::size_t k) {
            if (k <= i || abs(elements[k].position - elements[i].position) >= radius(i) + radius(k)) return true;
            const double vote = example.neighbor_above(elements[i], elements[k].position) -
                                example.neighbor_above(elements[k], elements[i].position);
            if (vote > 0) above[i].push_back(k);
            if (vote < 0) above[k].push_back(i);
            return true;
        });
    }
    return above;
}

}  // namespace

std::vector<std::size_t> paint_order(const Exemplar& exemplar, const std::vector<ArrangedElement>& elements) {
    std::vector<std::size_t> order(elements.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    if (!exemplar.outlines_overlap) return order;

    const OverlapEdges above = overlap_edges(exemplar, elements);
    std::vector<std::size_t> below(elements.size(), 0);
    for (const auto& upper : above) {
        for (const std::size_t k : upper) ++below[k];
    }
    // The next is one with nothing left below it; where that leads round in circles, one with the least.
    std::set<std::pair<std::size_t, std::size_t>> waiting;
    for (const std::size_t i : order) waiting.insert({below[i], i});
    order.clear();
    while (!waiting.empty()) {
        const std::size_t next = waiting.begin()->second;
        waiting.erase(waiting.begin());
        order.push_back(next);
        for (const std::size_t k : above[next]) {
            if (waiting.erase({below[k], k}) == 0) continue;
            waiting.insert({--below[k], k});
        }
    }
    return order;
}

}  // namespace rinceau
