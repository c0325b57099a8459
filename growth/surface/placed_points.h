#pragma once
// Nearest points in space of a set that grows while it is asked.

#include <array>
#include <optional>
#include <vector>

#include "growth/mesh/triangle_mesh.h"

namespace rinceau {

/// An octree whose leaves split as they fill. Points are numbered from 0 in the order of coming; coordinates are finite.
class PlacedPoints {
  public:
    void add(SpacePoint p);
    /// Takes back the point that was added last; there is one.
    void remove_last();
    int size() const { return static_cast<int>(points_.size()); }
    SpacePoint operator[](int index) const { return points_[static_cast<std::size_t>(index)]; }

    struct Nearest {
        int index = 0;
        double distance = 0;
    };
    /// But for one number; ties by number.
    std::optional<Nearest> nearest(SpacePoint p, int except = -1) const;
    /// All at a distance of at most `radius`, by rising number.
    std::vector<int> within(SpacePoint p, double radius) const;

  private:
    struct Node {
        SpacePoint low, high;  ///< box of the points that have been in it
        SpacePoint middle;     ///< of a split node
        int children = -1;     ///< the first of eight
        std::vector<int> points;
    };
    std::vector<SpacePoint> points_;
    std::vector<Node> nodes_;

    std::size_t child_of(const Node& node, SpacePoint p) const;
    void split(std::size_t node);
};

}  // namespace rinceau
