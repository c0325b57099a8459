#pragma once
// How often points stand at which distance from each other (Illian et al. 2008, "Statistical Analysis and Modelling of
// Spatial Point Patterns", section 4.3).

#include <span>
#include <vector>

#include "growth/measure/point_pattern.h"

namespace rinceau {

/// The pair correlation of every two kinds: 1 where points stand as often at that distance as points strewn by chance.
struct PairCorrelation {
    std::vector<double> radii;
    int symbols = 0;
    std::vector<std::vector<double>> of_pair;  ///< values per radius of symbols a and b at a * symbols + b
    std::vector<double> shares;                ///< of the symbols
};

/// Epanechnikov kernel of half width `bandwidth`, translation correction; on a tile without correction and with copies of a
/// point itself left out. Symbols are below `symbols`.
PairCorrelation pair_correlation(const PointPattern& pattern, int symbols, std::span<const double> radii, double bandwidth);

/// Mean of |g - g_reference| over the radii, which are the same, weighted with the radius, and over pairs of symbols,
/// weighted with their shares in the reference.
double distance(const PairCorrelation& correlation, const PairCorrelation& reference);

/// 40 radii from a quarter of the spacing to the lesser of 4 spacings and half of the pattern's shorter side.
std::vector<double> correlation_radii(const PointPattern& reference, double spacing);

/// Distance of the pattern from the reference, at the reference's radii with a bandwidth of 0.15 spacings.
double pair_distance(const PointPattern& pattern, const PointPattern& reference, int symbols, double spacing);

/// The same between halves of the pattern, mean of the cuts across x and y: what can be expected of chance.
double pair_spread(const PointPattern& pattern, int symbols, double spacing);

}  // namespace rinceau
