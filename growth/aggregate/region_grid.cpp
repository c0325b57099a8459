// Edges first: a region that overlaps another one nearly always crosses its outline, and the first crossing that is found in
// the lists of edges answers. Regions that cross no edge can only lie in one another as a whole: one corner of each tells.

#include "growth/aggregate/region_grid.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "geometry/orientation.h"

namespace rinceau {
namespace {

constexpr double edge_cell_factor = 1.5;  // cells a mean edge is long: 3 to 25 pairs of edges a test
constexpr std::size_t max_edge_cells = 4'000'000, max_box_cells = 500'000;

double greatest_radius(const std::vector<ExclusiveRegion>& regions) {
    double radius = 0;
    for (const ExclusiveRegion& region : regions) radius = std::max(radius, region.radius);
    return radius;
}

double mean_edge(const std::vector<ExclusiveRegion>& regions) {
    double length = 0;
    std::size_t count = 0;
    for (const ExclusiveRegion& region : regions)
        for (const auto& ring : region.rings) {
            for (std::size_t i = 0; i < ring.size(); ++i) length += abs(ring[(i + 1) % ring.size()] - ring[i]);
            count += ring.size();
        }
    return length / static_cast<double>(std::max<std::size_t>(count, 1));
}

Box reach_of(const std::vector<ExclusiveRegion>& regions, const PackDomain& domain, double max_scale) {
    // What hangs over the edge of a tile meets what comes in there; in a box or a region nothing hangs over.
    return domain.tiled ? grown(domain.box, greatest_radius(regions) * max_scale) : domain.box;
}

}  // namespace

RegionGrid::RegionGrid(const std::vector<ExclusiveRegion>& regions, const PackDomain& domain, double min_scale,
                       double max_scale)
    : domain_(domain),
      reach_(reach_of(regions, domain, max_scale)),
      // Between both ends of the scales; the largest regions then stand in more cells.
      edges_(reach_, edge_cell_factor * mean_edge(regions) * std::sqrt(min_scale * max_scale), max_edge_cells),
      boxes_(reach_, 2 * greatest_radius(regions) * std::sqrt(min_scale * max_scale), max_box_cells) {
    for (const ExclusiveRegion& region : regions) outlines_.push_back(flat(region.rings));
    outlines_.push_back(flat(domain.region.value_or(Region{})));
    list_domain();
}

RegionGrid::FlatRegion RegionGrid::flat(const std::vector<std::vector<Point>>& rings) {
    FlatRegion result;
    for (const auto& ring : rings) {
        const auto start = static_cast<std::uint32_t>(result.corners.size());
        const auto count = static_cast<std::uint32_t>(ring.size());
        result.ring_starts.push_back(start);
        result.corners.insert(result.corners.end(), ring.begin(), ring.end());
        for (std::uint32_t i = 0; i < count; ++i) result.next.push_back(start + (i + 1) % count);
    }
    return result;
}

Box RegionGrid::box_at(const FlatRegion& region, const Similarity& pose) const {
    Box box;
    for (const Point p : region.corners) box = including(box, apply(pose, p));
    return box;
}

void RegionGrid::list_domain() {
    if (!domain_.region) return;
    const auto shape = static_cast<std::uint32_t>(outlines_.size() - 1);
    const FlatRegion& outline = outlines_.back();
    standing_.push_back({shape, {}, box_at(outline, {})});
    list(0, true);
    for (const std::uint32_t start : outline.ring_starts) {
        const Point p = outline.corners[start];
        boxes_.add(boxes_.column_at(p.x), boxes_.row_at(p.y), {0, start});
    }
}

void RegionGrid::list(std::uint32_t owner, bool in) {
    const StandingRegion& region = standing_[owner];
    const FlatRegion& outline = outlines_[region.shape];
    const auto change = [in](CellLists& lists, int column, int row, CellEntry entry) {
        in ? lists.add(column, row, entry) : lists.remove(column, row, entry);
        return true;
    };
    for (std::uint32_t i = 0; i < outline.corners.size(); ++i) {
        const Point a = apply(region.pose, outline.corners[i]), b = apply(region.pose, outline.corners[outline.next[i]]);
        edges_.walk(a, b, [&](int column, int row) { return change(edges_, column, row, {owner, i}); });
    }
    if (region.shape + 1 == outlines_.size()) return;  // the domain: everything lies in its box
    boxes_.walk(region.box, [&](int column, int row) { return change(boxes_, column, row, {owner, 0}); });
}

void RegionGrid::stand(std::size_t index) {
    const auto [shape, pose] = placed_[index];
    const int ring = domain_.tiled ? 1 : 0;
    for (int down = -ring; down <= ring; ++down)
        for (int right = -ring; right <= ring; ++right) {
            const Point shift{right * width(domain_.box), down * height(domain_.box)};
            const Similarity moved = translate(shift) * pose;
            const Box box = box_at(outlines_[static_cast<std::size_t>(shape)], moved);
            if (!overlap(box, reach_)) continue;
            std::uint32_t slot = static_cast<std::uint32_t>(standing_.size());
            if (free_standing_.empty()) {
                standing_.push_back({});
            } else {
                slot = free_standing_.back();
                free_standing_.pop_back();
            }
            standing_[slot] = {static_cast<std::uint32_t>(shape), moved, box};
            standing_of_[index].push_back(slot);
            list(slot, true);
        }
}

void RegionGrid::place(const PlacedRegion& region) {
    placed_.push_back(region);
    standing_of_.push_back({});
    stand(placed_.size() - 1);
}

void RegionGrid::take_out(std::size_t index) {
    for (const std::uint32_t slot : standing_of_[index]) {
        list(slot, false);
        free_standing_.push_back(slot);
    }
    standing_of_[index].clear();
}

void RegionGrid::put_back(std::size_t index, const Similarity& pose) {
    assert(standing_of_[index].empty());
    placed_[index].pose = pose;
    stand(index);
}

bool RegionGrid::is_free(int shape, const Similarity& pose) {
    const FlatRegion& outline = outlines_[static_cast<std::size_t>(shape)];
    corners_.clear();
    Box box;
    for (const Point p : outline.corners) {
        corners_.push_back(apply(pose, p));
        box = including(box, corners_.back());
    }
    if (!domain_.tiled && !contains(domain_.box, box)) return false;
    if (!crosses_no_edge(outline)) return false;
    if (domain_.region && !holds(standing_.front(), corners_.front())) return false;
    return holds_nothing(outline, box);
}

bool RegionGrid::crosses_no_edge(const FlatRegion& region) const {
    for (std::size_t i = 0; i < corners_.size(); ++i) {
        const Point a = corners_[i], b = corners_[region.next[i]];
        const auto apart = [&](CellEntry entry) {
            const StandingRegion& other = standing_[entry.owner];
            const FlatRegion& outline = outlines_[other.shape];
            return !segments_meet(a, b, apply(other.pose, outline.corners[entry.part]),
                                  apply(other.pose, outline.corners[outline.next[entry.part]]));
        };
        if (!edges_.walk(a, b, [&](int column, int row) { return edges_.visit(column, row, apart); })) return false;
    }
    return true;
}

/// No edges cross. Regions are in one piece, so either the first corner of one lies in the other, or they are apart.
bool RegionGrid::holds_nothing(const FlatRegion& region, const Box& box) const {
    const auto apart = [&](CellEntry entry) {
        const StandingRegion& other = standing_[entry.owner];
        const FlatRegion& outline = outlines_[other.shape];
        const Point first = apply(other.pose, outline.corners[entry.part]);
        if (other.shape + 1 == outlines_.size()) return !holds(region, first);
        return !overlap(box, other.box) || (!holds(other, corners_.front()) && !holds(region, first));
    };
    return boxes_.walk(box, [&](int column, int row) { return boxes_.visit(column, row, apart); });
}

bool RegionGrid::holds(const StandingRegion& outer, Point p) const {
    const FlatRegion& outline = outlines_[outer.shape];
    bool inside = false;
    for (std::size_t i = 0; i < outline.corners.size(); ++i)
        inside ^= crosses_ray(apply(outer.pose, outline.corners[i]), apply(outer.pose, outline.corners[outline.next[i]]), p);
    return inside;
}

bool RegionGrid::holds(const FlatRegion& region, Point p) const {
    bool inside = false;
    for (std::size_t i = 0; i < corners_.size(); ++i) inside ^= crosses_ray(corners_[i], corners_[region.next[i]], p);
    return inside;
}

}  // namespace rinceau
