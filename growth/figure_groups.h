#pragma once
// Which shapes a person sees as one thing. Internal to the folder.

#include <vector>

#include "growth/figure_parts.h"

namespace rinceau {

/// Shapes that cover most of the picture, or reach across it below other shapes: none of them is an element. Ascending.
/// With `single`, where all the rest is one figure, only those that fill the picture's box.
std::vector<int> background_parts(const FigureParts& parts, bool single);

/// Groups of the given parts, each in paint order, the groups in order of their lowest parts. Joined are
///   - a shape that lies inside another one, or in its hole,
///   - shapes that touch, unless their like mostly stand alone (then they touch by chance), or so many touch that the group
///     would reach over half of the picture (then they tile it); in such a net the innermost groups of the grammar hold,
///   - shapes that a module of the grammar draws together and that are nearer to each other than to anything else,
///   - shapes that stand in clusters of equal composition everywhere.
std::vector<std::vector<int>> grouped_parts(const FigureParts& parts, const std::vector<int>& among);

}  // namespace rinceau
