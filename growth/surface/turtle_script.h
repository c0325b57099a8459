#pragma once
// A drawing's derivation as the way of its turtle, with the groups that its brackets and symbols make.

#include <vector>

#include "geometry/progress.h"
#include "lsystem/interpret.h"

namespace rinceau {

/// One thing that the turtle does, or the begin or end of a group.
struct TurtleDeed {
    TurtleEventKind kind = TurtleEventKind::moved;  ///< never turned: turning does not change places
    Point to;                                       ///< where the turtle stands in the drawing afterwards
    int element = -1;                               ///< of placed: index into TurtleScript::elements
    /// Of pushed and opened: the deed that ends the group. -1: not a group to be handled as one, as brackets that were open
    /// before it end in it, or as it is nested more deeply than max_nested_groups.
    int last = -1;
};

struct TurtleScript {
    std::vector<TurtleDeed> deeds;
    std::vector<Placement> elements;  ///< in order of derivation, with poses in the drawing and addresses
};

constexpr int max_nested_groups = 100;

/// Throws as interpret(), and LimitError for more than `max_elements`.
TurtleScript turtle_script(const Grammar& grammar, const DeriveOptions& options, long max_elements,
                           const Progress& progress = {});

}  // namespace rinceau
