#pragma once
// What a hypothesis is worth on the drawing, in bits (docs/analysis.md, 4.3; stands in for the importance function (5) of
// Stava et al. 2010, whose four weights multiply its terms).

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "analyzer/chains.h"
#include "analyzer/hypothesis.h"
#include "analyzer/importance_terms.h"
#include "analyzer/search_state.h"

namespace rinceau {

struct SearchOptions {
    ImportanceWeights weights;
    Objective objective = Objective::bits;
    double future = 0.5;  ///< share of the saving that equal groups may bring again on the next level
};

/// Look-up grids by part, made when first asked for.
class GridCache {
  public:
    explicit GridCache(const SearchState& state) : state_(&state) {}
    const PoseGrid& of(int part);
    void forget(int part) { grids_.erase(part); }

  private:
    const SearchState* state_;
    std::map<int, std::unique_ptr<PoseGrid>> grids_;
};

struct Evaluation {
    std::vector<Chain> chains;  ///< disjoint; of a group: pairs; of a linear rule: of equal first step
    Similarity step;            ///< refined on the chains
    double gain = 0;            ///< bits saved, all weights neutral: only > 0 is ever accepted
    double score = 0;           ///< weighted, with the hope for the next level: decides the order
    ImportanceTerms terms;      ///< Objective::paper: they decide instead
    int known_rule = -1;        ///< a rule that says the same already
    double ambiguity = 1;       ///< of a group: places where its second part could be found, for each that was used
};

Evaluation evaluate(const SearchState& state, GridCache& grids, const Hypothesis& hypothesis, const SearchOptions& options,
                    std::size_t rivals);

/// Votes are clustered at the tolerance, links are accepted at twice that (hysteresis).
PoseTolerance link_tolerance(const SearchState& state);

/// Before anything is looked up: an upper bound for the score.
double optimistic_score(const SearchState& state, const Hypothesis& hypothesis, const SearchOptions& options);

}  // namespace rinceau
