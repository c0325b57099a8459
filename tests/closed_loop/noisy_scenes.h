#pragma once
// Regular drawings with every element moved and turned a little, as by hand (docs/analysis.md, 4.8).

#include <cstdint>
#include <string>
#include <vector>

#include "scene/element.h"

namespace rinceau::test {

struct NoisyScene {
    Scene regular;      ///< as it was meant
    Scene drawn;        ///< the same elements in the same order, each shifted and turned
    std::string rules;  ///< of the regular one: rules_in_words of what a person sees
    double spacing = 0; ///< least distance of two elements
};

/// fig10_facade, grid_12x15, ring_12, rings_12x8, staggered_rows, circles_8x10, polar_3x12. Each coordinate is shifted by a uniform random
/// share of the spacing in [-jitter, jitter], each element turned by as many radians.
NoisyScene noisy_scene(const std::string& name, double jitter, std::uint64_t seed);

/// Their names.
std::vector<std::string> noisy_scene_names();

/// For each element of `wanted` the nearest one of `scene`.
Scene drawn_in_order_of(const Scene& wanted, const Scene& scene);

/// Root mean square distance of the centres of two scenes' boxes, elements in the same order.
double rms_distance(const Scene& a, const Scene& b);

}  // namespace rinceau::test
