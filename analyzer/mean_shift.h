#pragma once
// Mean shift clustering (Comaniciu and Meer 2002) of transformation spaces, as in Stava et al. 2010, section 4.3.

#include <vector>

#include "analyzer/transformation_space.h"

namespace rinceau {

/// Half widths of the kernel. The distance of two points is the root of the sum of squares of their differences in these
/// units; angles differ the short way round, scales by the logarithm of their ratio. All > 0.
struct MeanShiftBandwidths {
    double alpha = 0.05;      ///< radians
    double d = 0.05;          ///< units of the `from` element
    double log_scale = 0.05;  ///< natural logarithm
    double beta = 0.05;       ///< radians
};

struct TransformationCluster {
    double alpha = 0, d = 0, s = 1, beta = 0;  ///< the mode
    bool mirrored = false;
    int count = 0;
};

struct TransformationClusters {
    std::vector<TransformationCluster> clusters;  ///< by falling count, equal ones by their first point
    std::vector<int> cluster_of;                  ///< of each point
};

/// Every point climbs to a mode of the density under the Epanechnikov kernel (the shadow of the flat kernel: its mean shift
/// goes to the mean of the points within the bandwidth), the points themselves staying where they are; modes nearer than
/// half a bandwidth are one. Points within a sixteenth of a bandwidth count as one of their weight. Mirrored and unmirrored
/// points do not mix. The partition does not depend on the order of the points.
TransformationClusters mean_shift(const std::vector<TransformationPoint>& points,
                                  const MeanShiftBandwidths& bandwidths = {});

}  // namespace rinceau
