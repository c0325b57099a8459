#include "analyzer/open_with_progressions.h"

#include <algorithm>
#include <cmath>

#include "analyzer/fit_step.h"
#include "analyzer/join_items.h"
#include "analyzer/progression_law.h"
#include "analyzer/smooth_rows.h"
#include "geometry/kd_tree.h"

namespace rinceau {

namespace {

constexpr std::size_t neighbours_looked_at = 8;
constexpr std::size_t least_members = 6;
constexpr std::size_t least_of_whole = 4;    // if the row is the whole drawing ..
constexpr double fine_of_whole = 0.1;        // .. and fits to this share of the tolerance
constexpr std::size_t most_cuts = 24;        // shorter rows tried where a row ends in something else
constexpr double false_alarm_bits = -7;      // as in the search
constexpr double natural_slack = 0.5;        // of the tolerance, given up for round values

std::vector<std::vector<int>> neighbour_lists(const SearchState& state, int p) {
    std::vector<Point> origins;
    for (const int i : state.alive(p)) origins.push_back(state.item(i).pose.translation);
    const KdTree tree(origins);
    std::vector<std::vector<int>> lists(origins.size());
    for (std::size_t k = 0; k < origins.size(); ++k) {
        for (const Neighbor& near : tree.nearest(origins[k], neighbours_looked_at + 1)) {
            if (near.index != k) lists[k].push_back(state.alive(p)[near.index]);
        }
    }
    return lists;
}

struct Found {
    Rule rule;
    std::vector<Chain> rows;
};

class Progressions {
  public:
    Progressions(const SearchState& state, int p) : state_(state), p_(p), used_(state.rules.items.size(), 0) {
        for (const auto& members : state.members) living_ += members.size();
    }

    std::vector<Found> run() {
        const bool whole = living_ == state_.alive(p_).size() && living_ < 2 * least_members;
        const auto neighbours = neighbour_lists(state_, p_);
        auto rows = smooth_rows(state_, p_, neighbours, whole ? least_of_whole : least_members);
        std::ranges::stable_sort(rows, [](const auto& a, const auto& b) { return a.size() > b.size(); });
        for (const std::vector<int>& row : rows) take(row);
        for (Found& each : found_) {
            each.rule = fitted(each.rule, each.rows, radius());
            each.rule = with_natural_values(each.rule, each.rows, radius(), natural_slack * state_.tolerance.size);
        }
        return std::move(found_);
    }

  private:
    double radius() const { return std::max(1.0, state_.part(p_).radius); }

    /// How far off its place a member may be, in item sizes: more where steps are long.
    double slack(const Chain& row) const {
        const double step = abs(row.frames[1].translation - row.frames[0].translation) / scale_of(row.frames[0]);
        return state_.tolerance.shift(1, step);
    }

    void take(const std::vector<int>& row) {
        Chain chain;
        for (const int i : row) {
            if (!used_[static_cast<std::size_t>(i)]) chain.items.push_back(i);
        }
        if (chain.items.size() < row.size()) return;
        chain.frames = smooth_frames(state_, chain.items);
        if (chain.frames.size() < row.size()) return;
        if (join_known(chain)) return;
        for (std::size_t cuts = 0; cuts <= most_cuts && chain.items.size() >= least_of_whole; ++cuts) {
            const auto law = progression_of(state_, p_, chain, slack(chain));
            if (law && is_no_chance(chain, law->worst)) {
                found_.push_back({law->rule, {chain}});
                found_.back().rule.repeated = p_;
                mark(chain);
                return;
            }
            if (chain.items.size() <= least_members) return;
            chain.items.pop_back();
            chain.frames.pop_back();
        }
    }

    bool join_known(Chain& chain) {
        for (Found& each : found_) {
            if (each.rows.front().items.size() != chain.items.size()) continue;
            for (const bool reversed : {false, true}) {
                if (reversed) {
                    std::ranges::reverse(chain.items);
                    chain.frames = smooth_frames(state_, chain.items);
                }
                if (worst_deviation(each.rule, {&chain, 1}, radius()) > slack(chain)) continue;
                each.rows.push_back(chain);
                mark(chain);
                return true;
            }
            std::ranges::reverse(chain.items);
            chain.frames = smooth_frames(state_, chain.items);
        }
        return false;
    }

    void mark(const Chain& chain) {
        for (const int i : chain.items) used_[static_cast<std::size_t>(i)] = 1;
    }

    /// Would random places, angles and sizes show such a row less often than once in 2^7 drawings?
    bool is_no_chance(const Chain& chain, double worst) const {
        if (chain.items.size() == living_) return worst <= fine_of_whole * state_.tolerance.size || !is_short(chain);
        if (is_short(chain)) return false;
        const PartCost& cost = state_.cost(p_);
        const double sides = cost.neighbour_distance / cost.size;
        const double shift = slack(chain);
        constexpr double density = 0.25;  // of random points with distance 1 to the nearest
        const double link = std::log2(std::min(0.5, density * pi * shift * shift / (sides * sides))) - cost.angle_bits -
                            cost.scale_bits;
        constexpr double given = 3, ways = 36 * 4;  // links that fix a law; beginnings of a row at an item, kinds of laws
        const double beginnings = std::log2(static_cast<double>(state_.alive(p_).size()) * ways);
        return beginnings + (static_cast<double>(chain.items.size()) - 1 - given) * link < false_alarm_bits;
    }
    bool is_short(const Chain& chain) const { return chain.items.size() < least_members; }

    const SearchState& state_;
    int p_;
    std::size_t living_ = 0;
    std::vector<char> used_;
    std::vector<Found> found_;
};

}  // namespace

std::optional<SearchState> open_with_progressions(const SearchState& start) {
    std::optional<SearchState> opened;
    std::vector<int> touched;
    const auto parts = static_cast<int>(start.members.size());
    for (int p = 0; p < parts; ++p) {
        if (start.alive(p).size() < least_of_whole) continue;
        for (const Found& found : Progressions(start, p).run()) {
            if (!opened) opened = start;
            opened->rules.rules.push_back(found.rule);
            const int rule = static_cast<int>(opened->rules.rules.size()) - 1;
            for (const Chain& row : found.rows) join_items(*opened, rule, row.items, row.frames);
            touched.push_back(p);
            touched.push_back(static_cast<int>(opened->rules.parts.size()) - 1);
        }
    }
    if (opened) refresh(*opened, touched);
    return opened;
}

}  // namespace rinceau
