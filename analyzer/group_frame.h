#pragma once
// Groups as parts: their frame, their pose in the drawing and their own symmetry (docs/analysis.md, 4).

#include <span>
#include <vector>

#include "analyzer/rule_model.h"

namespace rinceau {

/// Children poses moved so that the mean of their origins is the group's origin; orientation and scale stay those of the
/// first.
std::vector<Similarity> centred(std::vector<Similarity> poses);

/// The similarity G that best maps the children's poses onto the frames (complex Procrustes over origins and linear parts,
/// the latter weighted by the children's radii squared). Same count, at least one; mirrored as the frames demand.
Similarity group_pose(std::span<const Similarity> children, std::span<const Similarity> frames,
                      std::span<const double> radii);

/// Completes a part whose look/rule/count/children are set: radius, leaves, symmetry. `still` and `turn` are the tolerances
/// for equal poses inside the group, in units of the child's size.
Part completed_part(const RuleSet& rules, Part part, double still, double turn);

}  // namespace rinceau
