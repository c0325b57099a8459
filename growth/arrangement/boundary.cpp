// Ijiri et al. 2008, section 3 (boundary tool). The paper tests the centres of elements; here it is their outlines, so that
// nothing that is drawn crosses a line.

#include "growth/arrangement/boundary.h"

#include "geometry/orientation.h"
#include "geometry/polygon.h"

namespace rinceau {
namespace {

Box box_of(Point a, Point b) { return including(including(Box{}, a), b); }

bool inside(const Region& region, Point p) {
    bool odd = false;
    for (const std::vector<Point>& ring : region) odd ^= inside_evenodd(ring, p);
    return odd;
}

Point nearest_of_segment(Point p, Point a, Point b) {
    const Point along = b - a;
    const double squared = norm(along);
    if (!(squared > 0)) return a;
    return a + std::clamp(dot(p - a, along) / squared, 0.0, 1.0) * along;
}

}  // namespace

Boundary::Boundary(std::vector<Polyline> lines, std::optional<Region> region)
    : lines_(std::move(lines)), region_(std::move(region)) {
    for (const Polyline& line : lines_) {
        for (std::size_t i = 1; i < line.size(); ++i) segments_.push_back({line[i - 1], line[i]});
    }
    const std::size_t of_lines = segments_.size();
    if (region_) {
        for (const std::vector<Point>& ring : *region_) {
            for (std::size_t i = 0; i < ring.size(); ++i) segments_.push_back({ring[i], ring[(i + 1) % ring.size()]});
        }
    }
    region_segments_ = segments_.size() - of_lines;

    std::vector<Box> boxes;
    boxes.reserve(segments_.size());
    for (const BoundarySegment& segment : segments_) boxes.push_back(box_of(segment.a, segment.b));
    tree_ = BoxTree(boxes);
}

bool Boundary::allows(Point p) const {
    if (!region_) return true;
    const std::size_t first = segments_.size() - region_segments_;
    bool odd = false;
    const Box ray{p, {std::numeric_limits<double>::infinity(), p.y}};
    tree_.visit(ray, [&](std::size_t i) {
        if (i >= first) odd ^= crosses_ray(segments_[i].a, segments_[i].b, p);
        return true;
    });
    return odd;
}

bool Boundary::crosses(Point a, Point b) const {
    return !tree_.visit(box_of(a, b), [&](std::size_t i) { return !segments_meet(segments_[i].a, segments_[i].b, a, b); });
}

bool Boundary::cuts(const Region& outline, const Similarity& pose) const {
    if (is_empty()) return false;
    if (outline.empty()) return !allows(pose.translation) || crosses(pose.translation, pose.translation);
    Region placed = outline;
    for (std::vector<Point>& ring : placed) {
        for (Point& p : ring) p = apply(pose, p);
    }
    return cuts_placed(placed);
}

bool Boundary::cuts_placed(const Region& outline) const {
    const auto apart = [&](const BoundarySegment& segment) {
        for (const std::vector<Point>& ring : outline) {
            for (std::size_t i = 0; i < ring.size(); ++i) {
                if (segments_meet(segment.a, segment.b, ring[i], ring[(i + 1) % ring.size()])) return false;
            }
        }
        return !inside(outline, segment.a);  // a segment that meets no edge lies inside as a whole, or not at all
    };
    if (!tree_.visit(bounds(outline), [&](std::size_t i) { return apart(segments_[i]); })) return true;
    // No ring meets the region's outline: each lies inside or outside as a whole.
    for (const std::vector<Point>& ring : outline) {
        if (!ring.empty() && !allows(ring.front())) return true;
    }
    return false;
}

std::optional<Point> Boundary::nearest(Point p, double within) const {
    std::optional<Point> best;
    double best_squared = within * within;
    std::size_t best_index = 0;
    tree_.visit(grown(Box{p, p}, within), [&](std::size_t i) {
        const Point candidate = nearest_of_segment(p, segments_[i].a, segments_[i].b);
        const double squared = norm(candidate - p);
        if (squared < best_squared || (squared == best_squared && (!best || i < best_index))) {
            best = candidate;
            best_squared = squared;
            best_index = i;
        }
        return true;
    });
    return best;
}

}  // namespace rinceau
