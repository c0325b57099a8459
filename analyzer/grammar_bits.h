#pragma once
// How long a description is, in bits, at one fixed precision (docs/analysis.md, "How a drawing and a grammar are measured").

#include <vector>

#include "analyzer/residuals.h"
#include "analyzer/rule_model.h"
#include "analyzer/to_grammar.h"

namespace rinceau {

struct DescriptionBits {
    double drawing = 0;  ///< every element written flat
    double grammar = 0;  ///< axiom, productions, constants, exceptions, residuals
    double unseen = 0;   ///< of these, residuals that no exception mends: too small to be seen
};

/// All elements written flat.
double flat_list_bits(const Instancing& instancing, double diagonal);

/// What with_residuals mended: leaves that deviate by more than `exact` (a scene length) after groups were moved.
struct LeftOver {
    const std::vector<double>& deviation;  ///< by leaf, as Residuals::left_over
    const std::vector<MovedGroup>& groups;
};

/// What a grammar and its residuals hold. Precision: 0.2 % of an element's size. The outlines of the terminals and the
/// styles' definitions count in neither.
DescriptionBits description_bits(const OrderedRules& ordered, const WrittenGrammar& written, const Grammar& final_grammar,
                                 const Instancing& instancing, const LeftOver& left_over, double diagonal, double exact = 0);

}  // namespace rinceau
