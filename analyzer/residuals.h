#pragma once
// Exact mode: elements that the rules miss by more than can be tolerated get an exception with what is left over
// (docs/analysis.md, 7).

#include <vector>

#include "analyzer/instancing.h"
#include "analyzer/to_grammar.h"
#include "lsystem/interpret.h"

namespace rinceau {

/// A terminal as the rules draw it, and what its element in the drawing differs by.
struct LeafResidual {
    Placement placement;   ///< with address and trail
    Similarity move;       ///< placement.pose * move is where the drawing has it, in the nearest gauge of its shape
    double deviation = 0;  ///< of the outline, scene length
    double reach = 0;      ///< of the outline from its own origin, scene length
};

/// In order of derivation.
std::vector<LeafResidual> leaf_residuals(const WrittenGrammar& written, const Instancing& instancing);

struct Residuals {
    Grammar grammar;                ///< with the exceptions
    std::vector<double> deviation;  ///< by leaf, before the exceptions: outline deviation, scene length
    int exceptions = 0;
};

/// Elements that deviate by more than `tolerance` (scene length) are moved to where the drawing has them.
Residuals with_residuals(const WrittenGrammar& written, const Instancing& instancing, double tolerance);

/// The same for residuals that are known, but for those leaves that are `left` where the rules draw them (by leaf; none if
/// it is empty).
Residuals with_residuals(const Grammar& grammar, const std::vector<LeafResidual>& residuals, double tolerance,
                         const std::vector<bool>& left = {});

}  // namespace rinceau
