#pragma once
// Where an arrangement grows, by the drawings that the command line names.

#include <optional>
#include <string>
#include <vector>

#include "cli/arrange_settings.h"
#include "growth/arrangement/exemplar.h"
#include "growth/arrangement/grow_arrangement.h"

namespace rinceau {

struct ArrangeGround {
    ArrangeSurroundings around;
    Box ground;                  ///< that growth begins in, and that it fills unless its order ends before
    std::optional<Box> canvas;   ///< none = it fits what grows
    std::vector<Brush> stops;    ///< of the brush; empty = none
    std::optional<Brush> limit;  ///< only seeds below it grow
    std::string confined_by;     ///< the input that leaves room for elements or not; empty = nothing does
};

/// Reads the drawings. `exemplar_canvas` is the picture of the exemplar. Throws as read_guide(), region_of() and
/// make_flow_field(), and InputError for a drawing without the lines that it is read for.
ArrangeGround read_arrange_ground(const ArrangeSettings& settings, const Exemplar& exemplar, const Box& exemplar_canvas);

}  // namespace rinceau
