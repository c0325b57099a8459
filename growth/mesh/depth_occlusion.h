#pragma once
// How much of the sky each point of a depth picture sees.

#include <array>
#include <vector>

namespace rinceau {

/// What is seen, row by row from the top; seen in parallel projection.
struct DepthImage {
    int width = 0, height = 0;
    std::vector<double> depth;                  ///< towards the eye, in units of a sample; -infinity = nothing there
    std::vector<std::array<float, 3>> normals;  ///< right, up, towards the eye; of length 1
};

/// The share of light from all around that reaches each sample, in [0, 1]: 1 on open and outward places, less in corners and
/// beside what stands out. From 16 taps within `radius` samples; turned from sample to sample and smoothed over the turns.
std::vector<float> open_sky(const DepthImage& image, double radius);

}  // namespace rinceau
