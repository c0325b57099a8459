#pragma once
// Rules as an L-system (Stava et al. 2010, sections 5.2 and 5.7; docs/analysis.md, 7).

#include <map>
#include <string>
#include <vector>

#include "analyzer/instancing.h"
#include "analyzer/order_rules.h"
#include "lsystem/grammar.h"
#include "scene/element.h"

namespace rinceau {

struct WrittenGrammar {
    Grammar grammar;                          ///< with exceptions for what is missing or replaced
    std::vector<int> element_of_leaf;         ///< scene element of each terminal in order of derivation
    std::vector<std::string> symbol_of_part;  ///< "" = not in use
    std::vector<Similarity> anchor_of_part;   ///< turtle frame of a part's module -> part frame
    std::vector<Similarity> terminal_anchor;  ///< by look: terminal frame -> unit frame
    std::map<std::string, int> tint_arguments;  ///< by symbol: how many of its last arguments choose styles (colouring.h)
};

/// Productions top-down, sequences as P(m) : m > 0 -> [A] T P(m-1) with m the number of repetitions, rings about their pivot
/// with the number of members as a constant, groups as one n-ary production. Numbers carry as few digits as keep every
/// element within `slack` (a scene length).
WrittenGrammar to_grammar(const OrderedRules& ordered, const Instancing& instancing, const Scene& scene, double slack);

}  // namespace rinceau
