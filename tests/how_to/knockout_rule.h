#pragma once
// A kind of rule that the search does not know: the plan of a knockout tournament. The worked example of
// docs/how_to/rule_kind.md.

#include <optional>
#include <span>

#include "lsystem/grammar.h"
#include "scene/element.h"

namespace rinceau {

/// A full binary tree of equal elements, level beside level at equal distances, each node in the middle between its two
/// successors: their distance halves from level to level while the elements stay as large as they are.
struct Knockout {
    int rounds = 0;    ///< levels below the final
    double way = 0;    ///< from a level to the next
    double half = 0;   ///< half the distance of the two nodes of a pair on the last level
    Similarity final;  ///< frame of the final's node -> scene: heading (+y) to the next level, unit scale
};

/// The plan that all of the places make, none missing and none too many, each within `tolerance` of where it has to be;
/// nothing if there is none or it has fewer than 3 rounds, which chance would show too often.
std::optional<Knockout> find_knockout(std::span<const Point> places, double tolerance);

/// Knockout(m) : m > 0 -> [A] [way out, to the left, Knockout(m-1)] [to the right], Knockout(0) -> [A], for a drawing that
/// consists of one such plan of copies of one element. Nothing if it does not, or if the rule does not draw the drawing.
std::optional<Grammar> knockout_grammar(const Scene& scene);

}  // namespace rinceau
