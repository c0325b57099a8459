#pragma once
// Compound paths taken apart: an outline with its holes is a piece, and pieces that do not touch are elements of their own.

#include <vector>

#include "scene/element.h"

namespace rinceau {

/// The sub-paths of one element in groups that draw the same when each is painted by itself, in the order of their first
/// sub-paths. Filled outlines stay with the holes in them; an island in a hole is a group of its own; outlines that share
/// more than a corner stay together. Strokes that touch stay together too, unless no order of painting can be seen (opaque, one colour).
/// When in doubt, or when the answer would take too long, sub-paths stay together.
std::vector<std::vector<Path>> connected_pieces(const std::vector<Path>& paths, const Style& style);

/// Every outline element replaced by its pieces; style and id go to each of them.
std::vector<Element> split_compound_paths(std::vector<Element> elements);

}  // namespace rinceau
