#pragma once
// Transformation spaces (Stava et al. 2010, section 4.3): for every ordered pair of looks, the transformations between
// their instances as points (alpha, d, s, beta). For display; the search for rules works on poses.

#include <cstddef>
#include <vector>

#include "analyzer/instancing.h"

namespace rinceau {

/// The pose of `to` in the frame of `from` as turtle commands +(alpha) f(d) *(s) +(beta). Heading = +y of the frame.
struct TransformationPoint {
    int from = 0, to = 0;   ///< elements
    double alpha = 0;       ///< turn before the advance, radians in (-pi, pi]; 0 where d vanishes
    double d = 0;           ///< advance, in units of the `from` element (its rms radius is 1)
    double s = 1;           ///< size of `to` over size of `from`
    double beta = 0;        ///< turn after the advance, radians in (-pi, pi]
    bool mirrored = false;  ///< one of the two is a mirror image of the other; beta is then that of the mirror image
};

struct TransformationSpace {
    int from = 0, to = 0;                     ///< looks
    std::vector<TransformationPoint> points;  ///< by (from, to) element
};

struct TransformationSpaceOptions {
    int neighbors = 8;         ///< of each element within the other look
    int all_pairs_up_to = 40;  ///< so few instances of both looks: all pairs
    /// In all spaces together; 0 = as many as there are. Spaces of the looks with the most instances come first, those that
    /// go beyond are left out; the first one is there whatever its size.
    std::size_t most_points = 0;
};

/// Spaces by (from, to), without empty ones. Angles of symmetric looks are reduced to those nearest 0 that draw the same;
/// verbatim elements take no part.
std::vector<TransformationSpace> fill_transformation_spaces(const Instancing& instancing,
                                                            const TransformationSpaceOptions& options = {});

/// inverse(from) * to as a point; elements are left 0.
TransformationPoint to_transformation_point(const Similarity& from, const Similarity& to);

}  // namespace rinceau
