#include "analyzer/complete_runs.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "analyzer/canonical_step.h"
#include "analyzer/gather.h"
#include "analyzer/regauge.h"

namespace rinceau {

namespace {

constexpr std::size_t most_witnesses = 6;  // whole runs that are compared with their shorter neighbours
constexpr std::size_t most_neighbours = 4;
constexpr int most_lines = 16;          // of one rule at a time
constexpr int most_lacking = 4;         // members at the ends of a run; shorter ones are left to the rule above
constexpr int fewest_runs = 3;
constexpr int fewest_whole = 2;
constexpr int one_missing_in = 8;  // members

/// A short run at its place in a line.
struct Completion {
    Gathered plan;
    Similarity pose;
};

struct SideBySide {
    int whole = 0;
    int missing = 0;
    std::vector<Completion> completions;
    int runs() const { return whole + static_cast<int>(completions.size()); }
};

class Completer {
  public:
    Completer(SearchState& state, GridCache& grids, int rule) : state_(state), grids_(grids), rule_(rule) {}

    void run(std::set<int>& touched) {
        for (int line = 0; line < most_lines; ++line) {
            if (!find_runs()) return;
            const auto best = best_line();
            if (!best || !complete(*best, touched)) return;
        }
    }

  private:
    /// Whole runs (of the largest count that two have) and the shorter ones; false if there are none of either.
    bool find_runs() {
        whole_ = -1;
        short_.clear();
        int largest = 0;
        for (std::size_t p = 0; p < state_.rules.parts.size(); ++p) {
            const Part& part = state_.rules.parts[p];
            if (part.rule != rule_ || state_.members[p].size() < fewest_whole || part.count <= largest) continue;
            largest = part.count;
            whole_ = static_cast<int>(p);
        }
        if (whole_ < 0) return false;
        for (std::size_t p = 0; p < state_.rules.parts.size(); ++p) {
            const Part& part = state_.rules.parts[p];
            if (part.rule != rule_ || part.count >= largest || part.count + most_lacking < largest) continue;
            short_.insert(short_.end(), state_.members[p].begin(), state_.members[p].end());
        }
        const int repeated = state_.rules.rules[static_cast<std::size_t>(rule_)].repeated;
        loose_ = state_.alive(repeated).size() >= 2;
        return !short_.empty() || loose_;
    }

    /// The line with the most runs, of equal ones that with the fewest members missing.
    std::optional<SideBySide> best_line() {
        std::optional<SideBySide> best;
        const std::vector<int>& whole = state_.alive(whole_);
        const std::size_t stride = 1 + (whole.size() - 1) / most_witnesses;
        for (std::size_t k = 0; k < whole.size(); k += stride) {
            for (const Similarity& step : steps_from(whole[k])) {
                const SideBySide line = line_along(whole[k], step);
                const bool enough = line.runs() >= fewest_runs && line.whole >= fewest_whole && !line.completions.empty() &&
                                    one_missing_in * line.missing <= line.runs() * state_.part(whole_).count;
                const auto rank = [](const SideBySide& l) { return std::pair{l.runs(), -l.missing}; };
                if (enough && (!best || rank(line) > rank(*best))) best = line;
            }
        }
        return best;
    }

    /// To where the shorter runs near by would stand if they were whole, and, if there are loose members, to where runs in
    /// pieces may stand half way to another whole run.
    std::vector<Similarity> steps_from(int whole) const {
        const Similarity& first = state_.item(whole).pose;
        std::vector<Similarity> steps;
        for (const int other : nearest_of(short_, whole)) {
            for (const Similarity& place : completed_places(other)) {
                steps.push_back(step_between(first, nearest_pose(state_.part(whole_), place, first)));
            }
        }
        if (!loose_) return steps;
        for (const int other : nearest_of(state_.alive(whole_), whole)) {
            if (other == whole) continue;
            Similarity step = step_between(first, nearest_pose(state_.part(whole_), state_.item(other).pose, first));
            step.translation = 0.5 * step.translation;
            if (abs(step.linear - Complex{1, 0}) <= state_.tolerance.angle && !step.mirrored) steps.push_back(step);
        }
        return steps;
    }

    std::vector<int> nearest_of(std::vector<int> nearest, int whole) const {
        const auto distance = [&](int i) {
            return std::pair{abs(state_.item(i).pose.translation - state_.item(whole).pose.translation), i};
        };
        const std::size_t count = std::min(nearest.size(), most_neighbours);
        std::ranges::partial_sort(nearest, nearest.begin() + static_cast<std::ptrdiff_t>(count), {}, distance);
        nearest.resize(count);
        return nearest;
    }

    /// Where a whole run would stand of which the short one is a piece.
    std::vector<Similarity> completed_places(int item) const {
        const Part& whole = state_.part(whole_);
        const Part& piece = state_.part(state_.item(item).part);
        std::vector<Similarity> places;
        for (std::size_t begin = 0; begin + piece.children.size() <= whole.children.size(); ++begin) {
            places.push_back(state_.item(item).pose * piece.children.front().pose * inverse(whole.children[begin].pose));
        }
        return places;
    }

    SideBySide line_along(int whole, const Similarity& step) {
        const Similarity& first = state_.item(whole).pose;
        SideBySide line;
        line.whole = 1;
        for (const Similarity& onward : {step, inverse(step)}) {
            std::set<int> seen{whole};
            for (Similarity pose = first * onward;; pose = pose * onward) {
                const auto found = gather(state_, grids_, whole_, pose, abs(onward.translation) * scale_of(pose));
                if (!found || (found->item >= 0 && !seen.insert(found->item).second)) break;
                if (found->item >= 0 && state_.item(found->item).part != whole_) break;
                if (found->item >= 0) {
                    ++line.whole;
                } else {
                    line.missing += found->exceptions;
                    line.completions.push_back({*found, pose});
                }
                if (line.runs() > static_cast<int>(state_.alive(whole_).size() + short_.size())) break;
            }
        }
        return line;
    }

    bool complete(const SideBySide& line, std::set<int>& touched) {
        bool any = false;
        for (const Completion& completion : line.completions) {
            std::set<int> parts;
            any |= make_item(state_, whole_, completion.plan, completion.pose, parts) >= 0;
            for (const int p : parts) grids_.forget(p);
            refresh(state_, {parts.begin(), parts.end()});
            touched.insert(parts.begin(), parts.end());
        }
        return any;
    }

    SearchState& state_;
    GridCache& grids_;
    int rule_;
    int whole_ = -1;
    std::vector<int> short_;
    bool loose_ = false;  ///< are there members without a run?
};

}  // namespace

void complete_runs(SearchState& state, GridCache& grids, Substitution& made) {
    improve_sequences(state, made, [&](int rule, std::set<int>& touched) { Completer(state, grids, rule).run(touched); });
}

}  // namespace rinceau
