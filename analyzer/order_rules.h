#pragma once
// Directions and orders inside rules that paint as the drawing does where elements overlap, and read in drawing order
// elsewhere (docs/analysis.md, 6). What remains wrong is left to layers (paint_order.h).

#include <vector>

#include "analyzer/overlaps.h"
#include "analyzer/rule_model.h"

namespace rinceau {

struct OrderedRules {
    RuleSet rules;           ///< steps and children reversed or reordered, members of items likewise
    std::vector<int> roots;  ///< living items in the order of the axiom
};

OrderedRules ordered_for_painting(RuleSet rules, const Overlaps& overlaps);

}  // namespace rinceau
