#pragma once
// Nearest points of a fixed set of points.

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "geometry/point.h"

namespace rinceau {

struct Neighbor {
    std::size_t index = 0;  ///< into the points that the tree was made of
    double distance = 0;
    friend constexpr bool operator==(const Neighbor&, const Neighbor&) = default;
};

/// A tree over a copy of the points. Answers are sorted by distance, ties by index, and do not depend on the tree's shape.
/// All coordinates must be finite. Queries are const and may run on several threads at a time.
class KdTree {
  public:
    explicit KdTree(std::span<const Point> points);
    ~KdTree();
    KdTree(KdTree&&) noexcept;
    KdTree& operator=(KdTree&&) noexcept;

    std::size_t size() const;
    /// The `count` nearest points (fewer if there are fewer).
    std::vector<Neighbor> nearest(Point p, std::size_t count) const;
    /// For every point of the tree its min(count, size() - 1) nearest others, nearest first: one list after the other.
    std::vector<int> nearest_others(std::size_t count) const;
    /// All points at a distance of at most `radius`.
    std::vector<Neighbor> within(Point p, double radius) const;

  private:
    struct Index;
    std::unique_ptr<Index> index_;
};

}  // namespace rinceau
