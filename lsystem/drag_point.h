#pragma once
// Numbers that bring a point of a drawing where it is wanted.

#include <optional>
#include <vector>

#include "lsystem/derivation_path.h"
#include "lsystem/numbers.h"

namespace rinceau {

/// A point that goes along with path[module] on the way to the element of that order.
struct AttachedPoint {
    int order = 0;
    std::size_t module = 0;
    Point local;  ///< in the turtle's frame at the module
};

/// What one more unit of a number does to the point, and to the module it belongs to.
struct PointChange {
    Point by;         ///< scene units
    double turn = 0;  ///< radians, counter-clockwise
    double growth = 0;  ///< of the logarithm of the scale
};

/// What can be dragged: a derivation, asked many times over. The numbers are those of the grammar as it is written, whose
/// own constants come last and own productions first in `resolved` (resolve_uses.h).
class PointDrag {
  public:
    PointDrag(const Grammar& written, const Grammar& resolved, const DeriveOptions& options = {});

    /// Where the module stands; nothing if there is none, or the grammar cannot be derived with these values.
    std::optional<Similarity> pose(const AttachedPoint& point, const std::vector<GrammarNumber>& numbers = {},
                                   const std::vector<double>& values = {}) const;

    /// Nothing if it is not known, as at an end of the number's range.
    std::optional<PointChange> change(const AttachedPoint& point, const GrammarNumber& number) const;

    /// Values of the numbers with which the point comes nearest to the target, found from their own values by a few steps
    /// of Gauss and Newton: round numbers, as short as `tolerance` (scene units) allows. One number alone, the first that
    /// can, is changed if that brings the point within `snap` of the target. Nothing if the point does not follow.
    std::optional<std::vector<double>> solve(const AttachedPoint& point, const std::vector<GrammarNumber>& numbers,
                                             Point target, double tolerance, double snap) const;

  private:
    Grammar grammar_;  ///< what has no part in where things stand is left out
    DeriveOptions options_;
    int constants_before_ = 0;  ///< of used files
};

}  // namespace rinceau
