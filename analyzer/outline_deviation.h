#pragma once
// How far apart two outlines are, for the independent check: measured along the true curves, both ways.

#include <vector>

#include "scene/path.h"

namespace rinceau {

struct DeviationOptions {
    double reach = 1;        ///< the search ends here: further counts as this far
    double accuracy = 1e-3;  ///< of the polylines that stand for the curves
    double small = 0;        ///< an upper bound of the deviation will do if it is below this
};

/// The largest distance of a point of either outline from the other one, at most `reach`. Points are tried at the ends of
/// all segments and at seven places within each, so that a moved node or handle shows.
double outline_deviation(const std::vector<Path>& a, const std::vector<Path>& b, const DeviationOptions& options);

/// Do outlines that deviate by `deviation` only wind alike, so that the non-zero rule fills the same? (The sum of the areas
/// of all sub-paths tells a hole from an island; a mirror image changes the sign of all of them.)
bool wind_alike(const std::vector<Path>& a, const std::vector<Path>& b, double deviation);

}  // namespace rinceau
