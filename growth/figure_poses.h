#pragma once
// Which groups of shapes are copies of one figure, and where they stand. Internal to the folder.

#include <optional>
#include <vector>

#include "growth/figure_parts.h"

namespace rinceau {

/// The similarity, mirror images among them, that takes one group of parts to another so that all parts fall on parts of the
/// same terminal, style and colours, with outlines that agree to a hundredth of the group's size; nothing if there is none.
std::optional<Similarity> same_figure(const FigureParts& parts, const std::vector<int>& from, const std::vector<int>& to);

/// What groups must have in common to be copies: sorted looks of their parts.
std::vector<std::vector<int>> looks_of(const FigureParts& parts, const std::vector<int>& group);

}  // namespace rinceau
