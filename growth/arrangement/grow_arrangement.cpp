// Ijiri et al. 2008, section 5: the loop. docs/growth.md lists what differs from the paper.
#include "growth/arrangement/grow_arrangement.h"

#include <algorithm>
#include <cmath>

#include "geometry/angle.h"
#include "growth/arrangement/node_links.h"
#include "growth/arrangement/place_element.h"
#include "growth/arrangement/relax_all.h"
#include "growth/arrangement/relax_near.h"

namespace rinceau {

namespace {

constexpr std::size_t most_elements = 1'000'000;  // of a growth that nothing else ends
constexpr double priority_reach = 5;              // mean edges (section 5.1)
constexpr int near_links = 2;                     // how far from a new element nodes are relaxed
constexpr int near_sweeps = 2;
constexpr std::size_t relax_all_growth = 4;  // the whole is relaxed whenever it has grown so many times: oftener is no better
constexpr int angle_rounds = 2;
constexpr std::size_t report_every = 64;     // steps

ArrangementNode& node_of(ElementArrangement& arrangement, int node) {
    return arrangement.nodes[static_cast<std::size_t>(node)];
}

/// One call of grow().
class Growing {
  public:
    Growing(ElementArrangement arrangement, const Exemplar& exemplar, const ArrangeSurroundings& around, const GrowOrder& order)
        : arrangement_(std::move(arrangement)),
          ground_(make_ground(exemplar, around, arrangement_.options)),
          matcher_(ground_, ground_.options.weights),
          order_(order) {}

    ElementArrangement run(const Progress& progress);

  private:
    SeedQueue& queue() { return order_.brush ? below_brush_ : arrangement_.queue; }
    bool is_below_brush(Point p) const { return !order_.brush || abs(p - order_.brush->center) <= order_.brush->radius; }
    void enqueue(int seed);
    void start_brush();
    std::optional<int> blocking_seed(int seed) const;
    void grow_seed(int seed);
    void settle(int element);
    int priority(int symbol) const;

    ElementArrangement arrangement_;
    GrowthGround ground_;
    RingMatcher matcher_;
    const GrowOrder& order_;
    SeedQueue below_brush_;
};

int Growing::priority(int symbol) const {
    const std::vector<int>& priorities = ground_.options.priorities;
    if (priorities.empty()) return 0;
    // A seed of any kind waits for all that have one.
    if (symbol < 0) return *std::min_element(priorities.begin(), priorities.end());
    return static_cast<std::size_t>(symbol) < priorities.size() ? priorities[static_cast<std::size_t>(symbol)] : 0;
}

}  // namespace
}  // namespace rinceau
