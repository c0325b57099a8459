#pragma once
// Transformation spaces as a table and as pictures.

#include <string>
#include <vector>

#include "analyzer/mean_shift.h"

namespace rinceau {

struct ClusteredSpace {
    TransformationSpace space;
    TransformationClusters clusters;
};

/// Every space with its clusters.
std::vector<ClusteredSpace> cluster_spaces(std::vector<TransformationSpace> spaces,
                                           const MeanShiftBandwidths& bandwidths = {});

/// One line a point under a heading line: from,to,from_element,to_element,alpha,d,s,beta,mirrored,cluster. Looks by name,
/// angles in degrees, elements and clusters counted from 0; cluster 0 of a space is its largest. `names` has one name for
/// each look.
std::string spaces_csv(const std::vector<ClusteredSpace>& spaces, const std::vector<std::string>& names);

/// An SVG drawing: for each space a title and two scatter plots, alpha against d and beta against s (log scale), a dot for
/// each different point, coloured by cluster; mirrored points are hollow. At most `most_spaces` spaces, those with the most
/// points.
std::string spaces_svg(const std::vector<ClusteredSpace>& spaces, const std::vector<std::string>& names,
                       std::size_t most_spaces = 200);

}  // namespace rinceau
