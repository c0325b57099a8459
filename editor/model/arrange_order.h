#pragma once
// What an arrangement is to do next, as a value: carried out where it may take its time.

#include <memory>
#include <vector>

#include "editor/model/arrange_steps.h"
#include "editor/model/growth_watch.h"

namespace rinceau {

struct ArrangeOrder {
    std::shared_ptr<const GrowthSource> source;  ///< with an exemplar
    std::shared_ptr<const GrownPattern> from;    ///< of the same source; null = nothing stands yet
    ArrangementSettings settings;                ///< of them, those of growth hold when it begins
    std::shared_ptr<const GuideLines> guides;    ///< never null
    Box canvas;
    std::vector<ArrangeStep> steps;
};

/// The flow and the boundary of the order. Throws InputError if flow is asked for and no stroke has a length.
ArrangeSurroundings surroundings_of(const ArrangeOrder& order);

/// The order's steps, one after the other: the same ones give the same arrangement however they are cut into orders. Throws
/// InputError as the growth, and what watch.progress throws.
GrownPattern arranged(const ArrangeOrder& order, const ArrangeSurroundings& around, const GrowthWatch& watch = {});

}  // namespace rinceau
