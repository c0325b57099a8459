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

/// A group whose elements were moved together.
struct MovedGroup {
    std::size_t first_leaf = 0, leaves = 0;  ///< in order of derivation
    double deviation = 0;                    ///< how far the farthest was moved, scene length
    bool turned = false;                     ///< or scaled
};

struct Residuals {
    Grammar grammar;                ///< with the exceptions
    std::vector<double> deviation;  ///< by leaf, before all exceptions: outline deviation, scene length
    std::vector<double> left_over;  ///< by leaf, where groups are moved
    std::vector<MovedGroup> groups;
    int exceptions = 0;
};

/// Above the first exception that moves something.
inline constexpr const char* residuals_comment =
    "from here on: where elements stand in the drawing; without these lines they stand regularly";

/// Elements that deviate by more than `tolerance` (scene length) are moved to where the drawing has them, one by one, but
/// for those leaves that are `left` where the rules draw them (by leaf; none if it is empty).
Residuals with_residuals(const Grammar& grammar, const std::vector<LeafResidual>& residuals, double tolerance,
                         const std::vector<bool>& left = {});

}  // namespace rinceau
