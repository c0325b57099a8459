#pragma once
// Small rule sets made by hand: parts with a given symmetry, copies in given places.

#include <vector>

#include "analyzer/chains.h"
#include "analyzer/rule_model.h"
#include "geometry/random.h"

namespace rinceau::test {

/// Rotations by 360 / n degrees.
SymmetryGroup cyclic(int n);
/// The same and n mirror images, one of them about the axis at `axis` radians from +x.
SymmetryGroup dihedral(int n, double axis = pi / 2);
/// Of a circle.
SymmetryGroup continuous();

/// A part that is a look; its number is its look's.
Part look_part(int look, SymmetryGroup symmetry);

/// One look with this symmetry, copies as items and elements 0, 1, ..
RuleSet copies(SymmetryGroup symmetry, const std::vector<Similarity>& poses);

/// The same copies, each in another one of its symmetry-equivalent poses.
RuleSet regauged_at_random(RuleSet rules, Random& random);

/// `rule` on all items of part 0, in their order: one new part (completed) and one new item that holds them.
RuleSet grouped(RuleSet rules, Rule rule);

/// 0, 1, .. count - 1
std::vector<int> counted(std::size_t count);

/// |difference| of the places plus |difference| of the linear parts; at least 2 if one is mirrored and the other is not.
double distance(const Similarity& a, const Similarity& b);

/// The least distance of a to b * s over the symmetries s; for a continuous part angles count for nothing.
double distance(const Similarity& a, const Similarity& b, const SymmetryGroup& symmetry);

}  // namespace rinceau::test
