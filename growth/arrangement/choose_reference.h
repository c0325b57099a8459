#pragma once
// The element of the exemplar that a seed becomes (Ijiri et al. 2008, eq. 1).

#include <vector>

#include "growth/arrangement/match_ring.h"

namespace rinceau {

/// What is charged for choosing a reference, beside its ring: copies of it nearby, and shares that drift.
class ReferenceCharges {
  public:
    /// For what stands or will stand at `at`; the node `except` does not count.
    ReferenceCharges(const ElementArrangement& arrangement, const GrowthGround& ground, Point at, int except);
    double of(int reference) const;

  private:
    const GrowthGround& ground_;
    const MatchWeights& weights_;
    std::vector<double> repeats_;  // by sub-id
    std::vector<double> surplus_;  // by symbol
};

/// The reference for a seed: of its symbol, or of any if it has none or if no usable element has it. What costs the same is
/// chosen by chance.
ReferenceMatch best_reference(const ElementArrangement& arrangement, const GrowthGround& ground, RingMatcher& matcher,
                              int seed, const TargetRing& ring, Random& random);

/// All that fit the seed, cheapest first, for when the first does not fit otherwise.
std::vector<ReferenceMatch> references_by_cost(const ElementArrangement& arrangement, const GrowthGround& ground,
                                               RingMatcher& matcher, int seed, const TargetRing& ring);

}  // namespace rinceau
