#pragma once
// A rule that may be: proposed by neighbours that agree, not yet tried on the drawing.

#include <vector>

#include "analyzer/rule_model.h"
#include "analyzer/step_votes.h"

namespace rinceau {

struct Hypothesis {
    RuleKind kind = RuleKind::sequence;  ///< sequence (rings come of it), linear or group
    int from = 0;                        ///< part; a sequence repeats it
    int to = 0;                          ///< group: the other part
    bool directed = false;               ///< `from` has no direction of its own: it heads along the step
    bool pairs_only = false;             ///< directed, and the turn from step to step is not known: pairs
    bool upright = false;                ///< linear: all members keep their heading
    Similarity step;
    double turn_change = 0;  ///< linear
    double spin_change = 0;
    std::vector<std::pair<int, int>> votes;  ///< (item of `from`, item of `to`)
    double votes_in_space = 0;               ///< all votes of the space that it was found in
};

}  // namespace rinceau
