#pragma once
// Copies that lie on each other in one place of the drawing only (docs/analysis.md, 5): a shape that is drawn twice is no rule
// that a person would see.

#include <vector>

#include "analyzer/rule_model.h"

namespace rinceau {

/// By part: is it a group of copies of one look, all in one place but for `slack` (a scene length), that nothing but one of the
/// `roots` uses, with nothing missing? The axiom then lists the copies at that place, and the part needs no name.
std::vector<bool> lone_stacks(const RuleSet& rules, const std::vector<int>& roots, double slack);

}  // namespace rinceau
