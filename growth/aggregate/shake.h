#pragma once
// Everything slides one way, so that small gaps become large ones that can be filled.

#include <cstddef>
#include <vector>

#include "growth/aggregate/packing.h"

namespace rinceau {

/// One round: all that is placed, the foremost first, slides along a direction until it meets something. Nothing overlaps in
/// between, and nothing is lost. The field is not kept up.
class ShakeRound {
  public:
    /// Directions of rounds 0, 1, .. are a golden angle apart, so that none comes again.
    ShakeRound(const Packing& packing, int round);

    /// Slides the next one; false if all have been.
    bool slide_next(Packing& packing);
    /// Share of what has been slid.
    double fraction() const;

  private:
    double direction_ = 0;
    std::vector<std::size_t> order_;
    std::size_t next_ = 0;
};

}  // namespace rinceau
