#pragma once
// An aggregate that is to be filled, as a value: carried out where it may take its time.

#include <memory>
#include <optional>

#include "editor/model/growth_watch.h"
#include "growth/aggregate/pack_domain.h"

namespace rinceau {

/// What the files hold that the settings name.
struct FillFiles {
    std::optional<Region> region;
    std::shared_ptr<const DensityPicture> density;  ///< its box does not count; null = none
};

struct FillOrder {
    std::shared_ptr<const GrowthSource> source;  ///< with figures
    AggregateSettings settings;
    Box canvas;  ///< that is filled unless there is a region
};

/// Stepwise: what is placed at any time is shown when the watch asks for it, and kept when it stops. Throws InputError if no
/// figure is chosen, and as exclusive_region() and AggregateFill; what watch.progress throws.
GrownPattern filled(const FillOrder& order, const FillFiles& files, const GrowthWatch& watch = {});

}  // namespace rinceau
