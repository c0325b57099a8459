#pragma once
// The shapes that stand, and what a new one must know of them: does it overlap, has it a twin, how near and how many are
// they (Li et al. 2010, sections 4.4.1 and 4.4.2).

#include <optional>
#include <span>
#include <vector>

#include "growth/surface/collision_space.h"
#include "growth/surface/placed_points.h"
#include "growth/surface/shape_scope.h"
#include "growth/surface/surface_pattern.h"

namespace rinceau {

class PlacedShapes {
  public:
    /// `shapes` outlive it. `sought`, by shape: distance() and twin() will be asked. Without `collisions` overlaps() will
    /// not.
    PlacedShapes(const std::vector<GrammarShape>& shapes, std::vector<bool> sought, bool collisions, double touch);

    /// Would the shape overlap one of those with numbers below `end`?  Those of `kin` it may touch.
    bool overlaps(const PatternShape& shape, const ScopeFrame& frame, std::span<const int> kin, int end) const;
    /// Its number: they rise from 0.
    int add(PatternShape shape, const ScopeFrame& frame, const ShapeScope& scope);
    /// Takes back everything from number `first` on.
    void remove_from(int first);

    const std::vector<PatternShape>& placed() const { return placed_; }
    int size() const { return static_cast<int>(placed_.size()); }
    long count(int shape) const { return counts_[static_cast<std::size_t>(shape)]; }
    /// From p to the nearest of that name but `except`; infinite if there is none.
    double distance(int shape, SpacePoint p, int except) const;

    /// The nearest of the same name within `distance` of the frame's position that the frame is turned by at most `degrees`
    /// against: the scope that it was placed in.
    struct Twin {
        int placed = 0;
        const ShapeScope* scope = nullptr;
    };
    std::optional<Twin> twin(int shape, const ScopeFrame& frame, double distance, double degrees) const;

  private:
    struct OfName {
        PlacedPoints points;
        std::vector<int> placed;         ///< by point
        std::vector<ShapeScope> scopes;  ///< by point
    };
    const std::vector<GrammarShape>* shapes_;
    std::vector<bool> sought_;
    bool collisions_;
    CollisionSpace space_;
    std::vector<PatternShape> placed_;
    std::vector<long> counts_;
    std::vector<OfName> of_name_;

    CollisionBody body_of(const PatternShape& shape, const ScopeFrame& frame) const;
};

}  // namespace rinceau
