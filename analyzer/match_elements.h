#pragma once
// Classes of elements of equal outline, each with a representative (Stava et al. 2010, section 4.1; docs/analysis.md, 1).
// The paper compares curvatures at samples; moments and a geometric check take their place: linear time, no threshold to
// tune, exact poses.

#include <vector>

#include "analyzer/instancing.h"

namespace rinceau {

struct ShapeClass {
    int representative = -1;  ///< element; its pose has angle 0 and no mirror
    SymmetryGroup symmetry;   ///< of the outline
    bool dots = false;        ///< outlines without extent; their unit is the stroke width
};

/// One element as a copy of its class.
struct ShapeMatch {
    int shape = -1;   ///< index into ShapeMatching::classes; -1 = verbatim
    Similarity pose;  ///< unit frame of the class -> scene, |linear| = rms radius; one of the equivalent ones
};

struct ShapeMatching {
    std::vector<ShapeClass> classes;  ///< by first appearance
    std::vector<ShapeMatch> matches;  ///< one for each element
};

ShapeMatching match_elements(const Scene& scene, const SimilarityOptions& options, const Progress& progress = {});

}  // namespace rinceau
