#pragma once
// How numbers of a grammar are disturbed at random.

namespace rinceau {

/// normal: most draws are near the number, few are far from it. uniform: every draw within the limits is as likely.
enum class NoiseDistribution : unsigned char { normal, uniform };

struct Noise {
    NoiseDistribution distribution = NoiseDistribution::normal;
    /// The standard deviation, or of `uniform` the greatest deviation to either side: in degrees, as a share of a distance,
    /// or of a scale's natural logarithm. Not below 0; 0 = none.
    double spread = 0;
    friend constexpr bool operator==(const Noise&, const Noise&) = default;
};

}  // namespace rinceau
