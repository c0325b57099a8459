#pragma once
// Exact mode for groups: where all elements of a group miss their places alike, the group is moved, by one exception
// (docs/analysis.md, 7).

#include "analyzer/residuals.h"

namespace rinceau {

struct GroupResiduals {
    Grammar grammar;  ///< with an exception for each moved group, behind those that it had
    std::vector<MovedGroup> groups;
};

/// Moves, from above, each module of a production that draws two elements or more beyond the tolerance (scene length), if a
/// move brings three of four of them within it. `residuals` are those of the grammar's leaves, in order of derivation.
/// Modules that already are exceptions, and those whose arguments depend on their production's parameters, stay.
GroupResiduals with_moved_groups(const Grammar& grammar, const std::vector<LeafResidual>& residuals, double tolerance);

/// Elements that deviate by more than `tolerance` (scene length) are moved to where the drawing has them: as groups where
/// they miss their places alike, then one by one.
Residuals with_residuals(const WrittenGrammar& written, const Instancing& instancing, double tolerance);

}  // namespace rinceau
