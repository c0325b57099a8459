#include "analyzer/layer_demands.h"

#include <algorithm>
#include <utility>

namespace rinceau {
namespace {

/// Sweeps over all demands before they count as contradictory. A demand travels along chains of demands within one sweep if
/// these are sorted; more are needed only where variables are shared.
constexpr int sweeps_per_attempt = 40;
/// Visits of demands in all attempts together: about a second.
constexpr std::size_t largest_work = 30'000'000;

struct Way {
    int lower = -1;  ///< variables where the ways from the root part; -1 = none that can be changed
    int upper = -1;
};

Way parting(const LayerHierarchy& h, int lower, int upper) {
    const auto up = [&](int node) { return h.parent[static_cast<std::size_t>(node)]; };
    const auto depth = [&](int node) { return h.depth[static_cast<std::size_t>(node)]; };
    int a = lower;
    int b = upper;
    int last_a = -1;
    int last_b = -1;
    const auto climb = [&](int& node, int& last) { last = std::exchange(node, up(node)); };
    while (depth(a) > depth(b)) climb(a, last_a);
    while (depth(b) > depth(a)) climb(b, last_b);
    while (a != b) {
        climb(a, last_a);
        climb(b, last_b);
    }
    const auto variable = [&](int node) { return node < 0 ? -1 : h.variable[static_cast<std::size_t>(node)]; };
    return {variable(last_a), variable(last_b)};
}

class Attempt {
  public:
    Attempt(const LayerHierarchy& hierarchy, const std::vector<LayerDemand>& demands, LayerDirection direction)
        : hierarchy_(hierarchy), demands_(demands), direction_(direction), active_(demands.size(), true) {
        for (const LayerDemand& demand : demands) ways_.push_back(parting(hierarchy, demand.lower, demand.upper));
        restart();
    }

    void restart() { values_.assign(static_cast<std::size_t>(hierarchy_.variables), 0); }
    void give_up(std::size_t demand) { active_[demand] = false; }
    const std::vector<int>& values() const { return values_; }

    int deficit(std::size_t i) const {
        const LayerDemand& demand = demands_[i];
        return demand.need + layer_of(hierarchy_, values_, demand.lower) - layer_of(hierarchy_, values_, demand.upper);
    }

    /// Meets each demand in turn; true if all of them were met when it came to them.
    bool sweep() {
        bool met = true;
        for (std::size_t k = 0; k < demands_.size(); ++k) {
            const std::size_t i = direction_ == LayerDirection::raise ? k : demands_.size() - 1 - k;
            if (!active_[i]) continue;
            const int missing = deficit(i);
            if (missing <= 0) continue;
            const int variable = direction_ == LayerDirection::raise ? ways_[i].upper : ways_[i].lower;
            if (variable < 0) {
                active_[i] = false;
                continue;
            }
            met = false;
            values_[static_cast<std::size_t>(variable)] += direction_ == LayerDirection::raise ? missing : -missing;
        }
        return met;
    }

    /// The active demand that is not met and that the fewest pairs ask for; demands().size() if there is none.
    std::size_t least_unmet() const {
        std::size_t least = demands_.size();
        for (std::size_t i = 0; i < demands_.size(); ++i) {
            if (active_[i] && deficit(i) > 0 && (least == demands_.size() || demands_[i].pairs < demands_[least].pairs))
                least = i;
        }
        return least;
    }

    /// Takes back what nothing needs: a change higher up may have made it needless.
    void take_back_needless() {
        for (std::size_t v = 0; v < values_.size(); ++v) {
            const int kept = std::exchange(values_[v], 0);
            if (kept != 0 && !all_met()) values_[v] = kept;
        }
    }

    bool all_met() const {
        for (std::size_t i = 0; i < demands_.size(); ++i) {
            if (active_[i] && deficit(i) > 0) return false;
        }
        return true;
    }

    bool nothing_given_up() const { return std::find(active_.begin(), active_.end(), false) == active_.end(); }

  private:
    const LayerHierarchy& hierarchy_;
    const std::vector<LayerDemand>& demands_;
    LayerDirection direction_;
    std::vector<bool> active_;
    std::vector<Way> ways_;
    std::vector<int> values_;
};

/// Of two demands that contradict each other outright, the one of fewer pairs.
void give_up_mutual(Attempt& attempt, const std::vector<LayerDemand>& demands) {
    std::vector<std::size_t> order(demands.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    const auto key = [&](std::size_t i) { return std::minmax(demands[i].lower, demands[i].upper); };
    std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return key(i) < key(j); });
    for (std::size_t k = 0; k + 1 < order.size(); ++k) {
        const std::size_t i = order[k];
        const std::size_t j = order[k + 1];
        if (key(i) != key(j) || demands[i].need + demands[j].need <= 0) continue;
        attempt.give_up(demands[i].pairs < demands[j].pairs ? i : j);
    }
}

}  // namespace

int layer_of(const LayerHierarchy& hierarchy, const std::vector<int>& values, int node) {
    int sum = 0;
    for (; node > 0; node = hierarchy.parent[static_cast<std::size_t>(node)]) {
        const int variable = hierarchy.variable[static_cast<std::size_t>(node)];
        if (variable >= 0) sum += values[static_cast<std::size_t>(variable)];
    }
    return sum;
}

LayerSolution meet_demands(const LayerHierarchy& hierarchy, const std::vector<LayerDemand>& demands,
                           LayerDirection direction, bool give_up) {
    Attempt attempt(hierarchy, demands, direction);
    if (give_up) give_up_mutual(attempt, demands);
    std::size_t work = 0;
    bool met = false;
    while (!met) {
        for (int sweep = 0; sweep < sweeps_per_attempt && !met && work < largest_work; ++sweep) {
            met = attempt.sweep();
            work += demands.size();
        }
        if (met || !give_up) break;
        const std::size_t least = attempt.least_unmet();
        if (least == demands.size()) break;
        if (work >= largest_work) {
            attempt.restart();
            return {attempt.values(), false};
        }
        attempt.give_up(least);
        attempt.restart();
    }
    if (met && attempt.values().size() * demands.size() < largest_work) attempt.take_back_needless();
    return {attempt.values(), met && attempt.nothing_given_up()};
}

}  // namespace rinceau
