#pragma once
// Groups of groups that are used in one place only become one group of many (docs/analysis.md, 5).

#include "analyzer/rule_model.h"

namespace rinceau {

/// The same drawing with every group part that only one other group uses spliced into that group, so that a chain of pairs
/// becomes one n-ary production (Stava et al. 2010, section 5.2: any production can be written as pairs, and back).
RuleSet with_inlined_groups(RuleSet rules);

}  // namespace rinceau
