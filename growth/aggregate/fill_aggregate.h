#pragma once
// A dense aggregate without period: exclusive regions that do not overlap (Sakurai & Miyata 2014).

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "geometry/progress.h"
#include "growth/aggregate/aggregate_options.h"
#include "growth/aggregate/exclusive_region.h"

namespace rinceau {

/// Filling that can be watched: each step() goes on where the last one stopped. The sequence of placements does not depend
/// on how it is cut into steps. What is placed at any time is free of overlap.
class AggregateFill {
  public:
    /// At least one region. Throws InputError in the name of `label`: the domain has no area, no shape fits into it at its
    /// least scale, a tile narrower than two diameters of a shape, shares or scales that are no such.
    AggregateFill(std::vector<ExclusiveRegion> regions, PackDomain domain, AggregateOptions options,
                  const std::string& label);
    ~AggregateFill();
    AggregateFill(AggregateFill&&) noexcept;
    AggregateFill& operator=(AggregateFill&&) noexcept;

    /// Tries up to `tries` placements; false when the method has come to its end.
    bool step(std::size_t tries);
    /// Work done, in [0, 1]: an estimate.
    double fraction() const;
    const std::vector<PlacedRegion>& placed() const;
    const AggregateCounts& counts() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// All at once. `stop` is asked now and then; true ends it with what is placed. Throws as AggregateFill.
Aggregate fill_aggregate(const std::vector<ExclusiveRegion>& regions, const PackDomain& domain,
                         const AggregateOptions& options, const std::string& label, const std::function<bool()>& stop = {},
                         const Progress& progress = {});

}  // namespace rinceau
