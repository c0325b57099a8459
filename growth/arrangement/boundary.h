#pragma once
// Lines that growth does not cross and the region that it stays in (Ijiri et al. 2008, section 3: boundary tool).

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "geometry/box_tree.h"
#include "growth/strokes.h"

namespace rinceau {

/// Boundary lines and a region, ready for queries. An empty one allows everything. All answers are exact for the coordinates
/// as they are given; queries may run on several threads at a time.
class Boundary {
  public:
    Boundary() = default;
    /// Outlines of the region are boundary lines, too.
    explicit Boundary(std::vector<Polyline> lines, std::optional<Region> region = {});

    bool is_empty() const { return segments_.empty(); }
    /// Inside the region, or there is none. On its outline, either answer.
    bool allows(Point p) const;
    /// Does a line stand between the two points, or on one of them?
    bool crosses(Point a, Point b) const;
    /// Does a line cross, touch or lie in the area of an outline that is placed by `pose`, or, with a region, does any of
    /// the outline lie outside? An outline without rings is the point that it is placed at.
    bool cuts(const Region& outline, const Similarity& pose) const;
    /// The nearest point of a line, if it is at most `within` away.
    std::optional<Point> nearest(Point p, double within) const;
    const std::vector<Polyline>& lines() const { return lines_; }
    const std::optional<Region>& region() const { return region_; }

  private:
    struct BoundarySegment {
        Point a, b;
    };
    std::vector<Polyline> lines_;
    std::optional<Region> region_;
    bool cuts_placed(const Region& outline) const;

    std::vector<BoundarySegment> segments_;  ///< of the lines, then of the region
    std::size_t region_segments_ = 0;
    BoxTree tree_;
};

}  // namespace rinceau
