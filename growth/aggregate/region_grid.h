#pragma once
// Which places are free: an exact test of an exclusive region against the domain and all regions that are placed (Sakurai &
// Miyata 2014, section 3.2, step 2).

#include <cstddef>
#include <cstdint>
#include <vector>

#include "growth/aggregate/aggregate_options.h"
#include "growth/aggregate/cell_lists.h"
#include "growth/aggregate/exclusive_region.h"
#include "growth/aggregate/pack_domain.h"

namespace rinceau {

/// Exclusive regions in a domain. What is asked and answered is exact for the corners apply(pose, corner) as they are
/// rounded to double: two regions overlap if they have a point in common, be it a corner; the holes of a region are not its
/// own. A region lies in the domain if it crosses no outline of it; on the border of a box it may stand.
class RegionGrid {
  public:
    /// Scales between min_scale and max_scale are expected; others are only slower. Of a tile, no region may be wider than
    /// half of it.
    RegionGrid(const std::vector<ExclusiveRegion>& regions, const PackDomain& domain, double min_scale, double max_scale);

    /// Inside the domain and free of all that is placed. Of a tile, the pose's origin lies in the box.
    bool is_free(int shape, const Similarity& pose);
    /// is_free() has said so. Its index is the number of those placed before.
    void place(const PlacedRegion& region);
    /// Out of the way, so that it can be put somewhere else; it keeps its index.
    void take_out(std::size_t index);
    void put_back(std::size_t index, const Similarity& pose);

    const std::vector<PlacedRegion>& placed() const { return placed_; }

  private:
    /// Rings one after the other; corner i is joined to corner next[i].
    struct FlatRegion {
        std::vector<Point> corners;
        std::vector<std::uint32_t> next;
        std::vector<std::uint32_t> ring_starts;
    };
    /// What stands in the lists: a placed region, the same moved by the width of the tile, or the domain's outline.
    struct StandingRegion {
        std::uint32_t shape = 0;
        Similarity pose;
        Box box;
    };

    static FlatRegion flat(const std::vector<std::vector<Point>>& rings);
    Box box_at(const FlatRegion& region, const Similarity& pose) const;
    void stand(std::size_t index);
    void list(std::uint32_t owner, bool in);
    void list_domain();
    bool crosses_no_edge(const FlatRegion& region) const;
    bool holds_nothing(const FlatRegion& region, const Box& box) const;
    bool holds(const StandingRegion& outer, Point p) const;
    bool holds(const FlatRegion& region, Point p) const;

    PackDomain domain_;
    std::vector<FlatRegion> outlines_;  ///< of the shapes; last that of the domain, empty for a box
    Box reach_;                         ///< where regions with their origin in the domain's box can be
    CellLists edges_, boxes_;           ///< parts: corner that an edge starts at; the domain's rings by their first corner
    std::vector<StandingRegion> standing_;
    std::vector<std::uint32_t> free_standing_;  ///< slots that are not in use
    std::vector<PlacedRegion> placed_;
    std::vector<std::vector<std::uint32_t>> standing_of_;  ///< of every placed region
    std::vector<Point> corners_;                           ///< of the region that is being tested
};

}  // namespace rinceau
