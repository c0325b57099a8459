#pragma once
// A group and its mirror image side by side, written as two halves about one axis: P -> [A] [| A] (docs/analysis.md, 5).

#include "analyzer/rule_model.h"

namespace rinceau {

/// Sequences of two groups, the second the mirror image of the first about a line, become groups of two halves; both are
/// written from a point of that line. Nothing that is drawn moves by more than 0.005 of an element's size.
RuleSet with_mirrored_halves(RuleSet rules);

}  // namespace rinceau
