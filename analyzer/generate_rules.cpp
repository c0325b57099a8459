#include "analyzer/generate_rules.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <set>

#include "analyzer/bridge_gaps.h"
#include "analyzer/close_rings.h"
#include "analyzer/complete_runs.h"
#include "analyzer/join_families.h"
#include "analyzer/propose.h"
#include "analyzer/settle_gaps.h"
#include "analyzer/substitute.h"

namespace rinceau {

namespace {

struct Candidate {
    Hypothesis hypothesis;
    Evaluation evaluation;
    bool evaluated = false;
    long version_from = -1, version_to = -1;  // of the parts when it was evaluated
    long generation = 0;                      // of its part's proposals, see propose_again
    bool dead = false;
};

/// Scores that differ by rounding only are equal: the order of the candidates decides, on any machine.
double rounded(double score) {
    constexpr double per_bit = 1 << 20;
    return std::round(score * per_bit) / per_bit;
}

struct Entry {
    double score;
    std::size_t candidate;
    bool operator<(const Entry& other) const {
        return score != other.score ? score < other.score : candidate > other.candidate;
    }
};

class Search {
  public:
    Search(SearchState state, const SearchOptions& options, const Progress& progress)
        : state_(std::move(state)), options_(options), progress_(progress), grids_(state_) {}

    SearchState run() {
        propose_everything();
        bool again = true;
        while (again) {
            again = false;
            while (accept_best()) again = true;
            // One full regeneration: neighbours have changed since.
            if (again) {
                candidates_.clear();
                queue_ = {};
                propose_everything();
            }
        }
        settle_gaps(state_, grids_);
        return std::move(state_);
    }

  private:
    long& version(int part) {
        if (versions_.size() <= static_cast<std::size_t>(part)) versions_.resize(static_cast<std::size_t>(part) + 1, 0);
        return versions_[static_cast<std::size_t>(part)];
    }

    void add(std::vector<Hypothesis> hypotheses) {
        for (Hypothesis& hypothesis : hypotheses) {
            const double bound = optimistic_score(state_, hypothesis, options_);
            if (bound <= 0) continue;
            queue_.push({rounded(bound), candidates_.size()});
            Candidate candidate;
            candidate.generation = proposals_of(hypothesis.from).generation;
            candidate.hypothesis = std::move(hypothesis);
            candidates_.push_back(std::move(candidate));
        }
    }

    struct Proposals {
        long generation = 0;
        std::size_t items = 0;  // that the part had when its sequences were proposed
    };
    Proposals& proposals_of(int part) {
        if (proposals_.size() <= static_cast<std::size_t>(part)) proposals_.resize(static_cast<std::size_t>(part) + 1);
        return proposals_[static_cast<std::size_t>(part)];
    }

    void propose_sequences_of(int part) {
        Proposals& proposals = proposals_of(part);
        ++proposals.generation;
        proposals.items = state_.alive(part).size();
        add(propose_sequences(state_, part));
    }

    void propose_everything() {
        std::vector<int> everything;
        for (std::size_t p = 0; p < state_.members.size(); ++p) {
            tell();
            propose_sequences_of(static_cast<int>(p));
            everything.insert(everything.end(), state_.members[p].begin(), state_.members[p].end());
        }
        std::ranges::sort(everything);
        add(propose_groups(state_, everything));
    }

    bool is_current(const Candidate& candidate) {
        return candidate.evaluated && candidate.version_from == version(candidate.hypothesis.from) &&
               candidate.version_to == version(candidate.hypothesis.to);
    }

    /// Sequences of a part are proposed anew when it has changed much; the old ones are then forgotten.
    bool is_outdated(const Candidate& candidate) {
        return candidate.hypothesis.kind != RuleKind::group &&
               candidate.generation != proposals_of(candidate.hypothesis.from).generation;
    }

    /// Takes hypotheses from the queue, best first, evaluating lazily, until one is worth a rule.
    bool accept_best() {
        while (!queue_.empty()) {
            const Entry entry = queue_.top();
            queue_.pop();
            Candidate& candidate = candidates_[entry.candidate];
            if (candidate.dead || entry.score <= 0 || is_outdated(candidate)) continue;
            if (!is_current(candidate)) {
                tell();
                candidate.evaluation = evaluate(state_, grids_, candidate.hypothesis, options_, queue_.size());
                candidate.evaluated = true;
                candidate.version_from = version(candidate.hypothesis.from);
                candidate.version_to = version(candidate.hypothesis.to);
                const bool worth = candidate.evaluation.gain > 0 && candidate.evaluation.score > 0;
                if (worth) {
                    queue_.push({rounded(score_of(candidate.evaluation)), entry.candidate});
                } else {
                    candidate.evaluation = {};
                }
                continue;
            }
            // Shares of the largest have shrunk if a larger one was met since.
            if (const double score = rounded(score_of(candidate.evaluation)); score < entry.score) {
                queue_.push({score, entry.candidate});
                continue;
            }
            if (apply(candidate)) return true;
            candidate.dead = true;
        }
        return false;
    }

    double score_of(const Evaluation& evaluation) {
        if (options_.objective == Objective::bits) return evaluation.score;
        largest_.elements = std::max(largest_.elements, evaluation.terms.elements);
        largest_.length = std::max(largest_.length, evaluation.terms.length);
        return importance(evaluation.terms, largest_, options_.weights);
    }

    bool apply(Candidate& candidate) {
        const Hypothesis hypothesis = candidate.hypothesis;
        Substitution made = substitute(state_, hypothesis, candidate.evaluation);
        if (made.new_items.empty()) return false;
        candidate.dead = true;
        for (const int part : made.touched_parts) grids_.forget(part);
        bridge_gaps(state_, grids_, made);
        complete_runs(state_, grids_, made);
        close_rings(state_, grids_, made);
        for (const int part : made.touched_parts) ++version(part);
        propose_anew(made);
        consumed_ += static_cast<double>(made.new_items.size());
        tell();
        return true;
    }

    void tell() const { report(progress_, "rules", 1 - 1 / (1 + consumed_ / 10)); }

    void propose_anew(const Substitution& made) {
        // Parts that lost items: the hypotheses about what is left may have been hidden before.
        constexpr std::size_t small_part = 40;
        for (const int part : made.touched_parts) {
            const std::size_t left = state_.alive(part).size(), before = proposals_of(part).items;
            const bool much_the_same = left <= before && left > small_part && 5 * left >= 4 * before;
            if (!much_the_same) propose_sequences_of(part);
        }
        add(propose_groups(state_, made.new_items));
    }

    SearchState state_;
    SearchOptions options_;
    const Progress& progress_;
    GridCache grids_;
    std::vector<Candidate> candidates_;
    std::priority_queue<Entry> queue_;
    std::vector<long> versions_;
    std::vector<Proposals> proposals_;
    ImportanceTerms largest_;  // of all hypotheses so far
    double consumed_ = 0;
};

}  // namespace

SearchState generate_rules(SearchState state, const SearchOptions& options, const Progress& progress) {
    SearchState found = Search(std::move(state), options, progress).run();
    // Families may stand in rows again.
    while (join_families(found)) found = Search(std::move(found), options, progress).run();
    return found;
}

}  // namespace rinceau
