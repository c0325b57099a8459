#pragma once
// What cannot be packed is refused before any work is done.

#include <string>
#include <vector>

#include "growth/aggregate/aggregate_options.h"
#include "growth/aggregate/exclusive_region.h"
#include "growth/aggregate/pack_domain.h"

namespace rinceau {

/// The shares of the shapes, equal where none are given; 0 for a shape that cannot fit at its least scale whatever its
/// angle. Throws InputError in the name of `label`, as AggregateFill says.
std::vector<double> checked_shares(const std::vector<ExclusiveRegion>& regions, const PackDomain& domain,
                                   const AggregateOptions& options, const std::string& label);

}  // namespace rinceau
