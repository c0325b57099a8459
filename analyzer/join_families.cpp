#include "analyzer/join_families.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "analyzer/chains.h"
#include "analyzer/evaluate.h"
#include "analyzer/fit_step.h"
#include "analyzer/gather.h"
#include "analyzer/join_items.h"
#include "analyzer/regauge.h"

namespace rinceau {

namespace {

constexpr int most_difference = 3;          // of the counts of neighbouring rows
constexpr std::size_t most_rows = 200;      // of one rule that are looked at
constexpr std::size_t least_rows = 4;
constexpr int fewest_gathered = 2;          // shorter rows are looked for among what is left single
constexpr double natural_slack = 0.5;       // of the tolerance, given up for round values

class FamilyFinder {
  public:
    FamilyFinder(SearchState& state, int rule) : state_(state), rule_(rule) {
        for (std::size_t p = 0; p < state.rules.parts.size(); ++p) {
            if (state.part(static_cast<int>(p)).rule != rule) continue;
            rows_.insert(rows_.end(), state.members[p].begin(), state.members[p].end());
        }
        std::ranges::stable_sort(rows_, [&](int a, int b) { return count(a) > count(b); });
    }

    bool run() {
        if (rows_.size() + 1 < least_rows || rows_.size() > most_rows) return false;
        bool any = false;
        for (const int first : rows_) {
            Chain best;
            int difference = 0;
            for (int d = 1; d <= most_difference; ++d) {
                for (const int second : rows_) {
                    if (!free(first) || !free(second) || count(first) - count(second) != d) continue;
                    Chain chain = longest(first, second, d);
                    if (chain.items.size() <= best.items.size()) continue;
                    best = std::move(chain);
                    difference = d;
                }
            }
            const std::size_t rows = best.items.size() + (last_is_open(best, difference) ? 1 : 0);
            if (best.items.empty() || rows < least_rows) continue;
            join(best, difference);
            any = true;
        }
        return any;
    }

  private:
    int count(int row) const { return state_.part(state_.item(row).part).count; }
    bool free(int row) const { return state_.item(row).alive; }
    const Rule& rule() const { return state_.rules.rules[static_cast<std::size_t>(rule_)]; }

    /// A row shorter than those that the search makes could follow.
    bool last_is_open(const Chain& chain, int difference) const {
        return !chain.items.empty() && count(chain.items.back()) - difference >= 1 &&
               count(chain.items.back()) - difference <= fewest_gathered;
    }

    /// The longest chain that begins with these two, over the gauges of both.
    Chain longest(int first, int second, int difference) const {
        Chain best;
        for (const Similarity& a : state_.part(state_.item(first).part).symmetry.elements) {
            for (const Similarity& b : state_.part(state_.item(second).part).symmetry.elements) {
                Chain chain;
                chain.items = {first, second};
                chain.frames = {state_.item(first).pose * a, state_.item(second).pose * b};
                if (chain.frames[0].mirrored != chain.frames[1].mirrored) continue;
                const Similarity step = inverse(chain.frames[0]) * chain.frames[1];
                while (extend(chain, step, difference)) {}
                if (chain.items.size() > best.items.size()) best = std::move(chain);
            }
        }
        return best;
    }

    bool extend(Chain& chain, const Similarity& step, int difference) const {
        const int wanted = count(chain.items.back()) - difference;
        const Similarity predicted = chain.frames.back() * step;
        const double distance = abs(predicted.translation - chain.frames.back().translation);
        const PoseTolerance tolerance = link_tolerance(state_);
        for (const int row : rows_) {
            if (count(row) != wanted || !free(row)) continue;
            const Similarity& pose = state_.item(row).pose;
            const double size = scale_of(predicted);
            if (abs(pose.translation - predicted.translation) > tolerance.shift(size, distance)) continue;
            const Part& part = state_.part(state_.item(row).part);
            const Similarity frame = nearest_pose(part, pose, predicted);
            if (frame.mirrored != predicted.mirrored) continue;
            if (abs(frame.linear - predicted.linear) > tolerance.turn(part.radius) * size) continue;
            chain.items.push_back(row);
            chain.frames.push_back(frame);
            return true;
        }
        return false;
    }

    void join(Chain& chain, int difference) {
        const Rule row_rule = rule();
        Rule family;
        family.kind = RuleKind::family;
        family.repeated = state_.item(chain.items.front()).part;
        const double radius = std::max(1.0, state_.part(family.repeated).radius);
        family.step = mean_step({&chain, 1});
        gather_short_rows(chain, family.step, difference);
        family = fitted(family, {&chain, 1}, radius);
        family = with_natural_values(family, {&chain, 1}, radius, natural_slack * state_.tolerance.size);
        join_family(state_, family, chain.items, chain.frames);
        refresh_all();
    }

    /// Rows of two and of one that the search has left as single items.
    void gather_short_rows(Chain& chain, const Similarity& step, int difference) {
        GridCache grids(state_);
        for (int wanted = count(chain.items.back()) - difference; wanted >= 1 && wanted <= fewest_gathered; wanted -= difference) {
            const Similarity predicted = chain.frames.back() * step;
            const double distance = abs(predicted.translation - chain.frames.back().translation);
            const int part = part_of_count(state_, rule_, wanted);
            std::vector<int> items;
            std::vector<Similarity> frames;
            for (const Child& child : std::vector<Child>(state_.part(part).children)) {
                const Similarity place = predicted * child.pose;
                const auto match = grids.of(child.part).find(place, distance, link_tolerance(state_));
                if (!match || std::ranges::find(items, match->item) != items.end()) return;
                items.push_back(match->item);
                frames.push_back(nearest_pose(state_.part(child.part), state_.item(match->item).pose, place));
            }
            const int row = join_items(state_, rule_, items, frames);
            grids.forget(state_.part(part).children.front().part);
            const Similarity frame = nearest_pose(state_.part(part), state_.item(row).pose, predicted);
            chain.items.push_back(row);
            chain.frames.push_back(frame);
        }
    }

    void refresh_all() {
        std::vector<int> parts(state_.rules.parts.size());
        for (std::size_t p = 0; p < parts.size(); ++p) parts[p] = static_cast<int>(p);
        refresh(state_, parts);
    }

    SearchState& state_;
    int rule_;
    std::vector<int> rows_;  // living items of the rule, longest first
};

}  // namespace

bool join_families(SearchState& state) {
    bool any = false;
    const std::size_t rules = state.rules.rules.size();
    for (std::size_t r = 0; r < rules; ++r) {
        if (state.rules.rules[r].kind != RuleKind::sequence) continue;
        any = FamilyFinder(state, static_cast<int>(r)).run() || any;
    }
    return any;
}

}  // namespace rinceau
