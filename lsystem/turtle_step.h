#pragma once
// A similarity as the turtle walks it: +(turn) f(advance) *(scale) +(spin), then | if mirrored (Stava et al. 2010,
// section 4.3).

#include "geometry/similarity.h"

namespace rinceau {

/// (alpha, d, s, beta) in the local frame, heading = +y. Angles in radians, counter-clockwise, in (-pi, pi]; scale > 0.
struct TurtleStep {
    double turn = 0;
    double advance = 0;
    double scale = 1;
    double spin = 0;
    bool mirrored = false;
    friend constexpr bool operator==(const TurtleStep&, const TurtleStep&) = default;
};

/// turn = 0 if the step does not advance by more than `still` (a length).
TurtleStep to_turtle_step(const Similarity& map, double still = 0);

Similarity to_similarity(const TurtleStep& step);

}  // namespace rinceau
