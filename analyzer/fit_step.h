#pragma once
// The step of a rule from its chains: least squares over whole chains (docs/analysis.md, 4.5), then natural values where
// they fit as well.

#include <span>

#include "analyzer/chains.h"
#include "analyzer/rule_model.h"

namespace rinceau {

/// The mean of the steps between successive frames; enough to search with.
Similarity mean_step(std::span<const Chain> chains);

/// The rule (kind, step, changes as a first guess) with its step fitted by Gauss-Newton so that every chain, each with its
/// own free pose, ends where the drawing ends. A ring's step turns by exactly 2 pi k / n and keeps the size.
/// `radius` is the repeated part's.
Rule fitted(const Rule& rule, std::span<const Chain> chains, double radius);

/// The rule with scale 1, angles that are multiples of 15 degrees, equal turns and so on, each where no item moves by more
/// than `slack` of its size because of it.
Rule with_natural_values(Rule rule, std::span<const Chain> chains, double radius, double slack);

/// Largest deviation of an item from its rule, in item sizes, each chain in its best pose.
double worst_deviation(const Rule& rule, std::span<const Chain> chains, double radius);

}  // namespace rinceau
