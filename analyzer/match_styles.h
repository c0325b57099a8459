#pragma once
// Looks: shapes in the styles that they are painted in, compared in the unit frame (docs/analysis.md, 2).

#include <vector>

#include "analyzer/match_elements.h"
#include "analyzer/painted_form.h"

namespace rinceau {

struct StyledLook {
    int shape = -1;  ///< -1 = verbatim
    int style = -1;
    int first = -1;  ///< first element in paint order
    Style unit_style;
    PaintedForm form;
    SymmetryGroup symmetry;  ///< the part of the shape's group that keeps style, starts and ends
};

struct StyleMatching {
    std::vector<StyledLook> looks;    ///< by first appearance
    std::vector<Instance> instances;  ///< one for each element
    int styles = 0;
};

/// Splits every shape class by style. Where a shape has symmetries, the pose of a copy is chosen among the equivalent ones
/// so that its style is that of a look already found; then without mirror image; then nearest in angle to the look's first
/// copy.
StyleMatching match_styles(const Scene& scene, const ShapeMatching& shapes);

}  // namespace rinceau
