#include "geometry/kd_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nanoflann.hpp>
#include <utility>

namespace rinceau {

namespace {

constexpr std::size_t points_per_leaf = 12;

// How nanoflann sees the points.
struct PointCloud {
    std::vector<Point> points;
    std::size_t kdtree_get_point_count() const { return points.size(); }
    double kdtree_get_pt(std::size_t index, std::size_t dimension) const {
        return dimension == 0 ? points[index].x : points[index].y;
    }
    template <class BoundingBox>
    bool kdtree_get_bbox(BoundingBox&) const {
        return false;
    }
};

bool comes_before(const Neighbor& a, const Neighbor& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.index < b.index;
}

/// Receives candidates from nanoflann and keeps the `count` first by distance and index, in order.
class NearestFew {
  public:
    explicit NearestFew(std::size_t count) : count_(count) { kept_.reserve(count + 1); }

    std::size_t size() const { return kept_.size(); }
    bool full() const { return kept_.size() == count_; }
    // NOLINTNEXTLINE(readability-identifier-naming): nanoflann's names
    bool addPoint(double square, std::size_t index) {
        const Neighbor candidate{index, std::sqrt(square)};
        if (full() && !comes_before(candidate, kept_.back())) return true;
        kept_.insert(std::upper_bound(kept_.begin(), kept_.end(), candidate, comes_before), candidate);
        if (kept_.size() > count_) kept_.pop_back();
        if (full()) {
            // A little more, since ties count and squares are rounded.
            constexpr double margin = 1e-9;
            const double worst = kept_.back().distance;
            worst_ = worst * worst * (1 + margin) + std::numeric_limits<double>::min();
        }
        return true;
    }
    double worstDist() const { return worst_; }  // NOLINT(readability-identifier-naming)
    void clear() {
        kept_.clear();
        worst_ = std::numeric_limits<double>::max();
    }
    const std::vector<Neighbor>& kept() const { return kept_; }

  private:
    std::size_t count_;
    std::vector<Neighbor> kept_;
    double worst_ = std::numeric_limits<double>::max();
};

using Tree =
    nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, PointCloud>, PointCloud, 2, std::size_t>;

}  // namespace

struct KdTree::Index {
    PointCloud cloud;
    Tree tree;
    explicit Index(std::span<const Point> points)
        : cloud{{points.begin(), points.end()}},
          tree(2, cloud, nanoflann::KDTreeSingleIndexAdaptorParams(points_per_leaf)) {}
};

KdTree::KdTree(std::span<const Point> points) : index_(std::make_unique<Index>(points)) {}
KdTree::~KdTree() = default;
KdTree::KdTree(KdTree&&) noexcept = default;
KdTree& KdTree::operator=(KdTree&&) noexcept = default;

std::size_t KdTree::size() const { return index_->cloud.points.size(); }

std::vector<Neighbor> KdTree::within(Point p, double radius) const {
    if (size() == 0 || !(radius >= 0)) return {};
    // nanoflann leaves out what is exactly at the radius and rounds squares: ask for a little more, then judge by distance.
    const double margin = 1e-9;
    const double squared = radius * radius * (1 + margin) + std::numeric_limits<double>::min();
    const double query[2] = {p.x, p.y};
    std::vector<std::pair<std::size_t, double>> found;
    nanoflann::SearchParams unsorted;
    unsorted.sorted = false;
    index_->tree.radiusSearch(query, squared, found, unsorted);
    std::vector<Neighbor> neighbors;
    neighbors.reserve(found.size());
    for (const auto& [index, unused] : found) {
        const double distance = abs(index_->cloud.points[index] - p);
        if (distance <= radius) neighbors.push_back({index, distance});
    }
    std::sort(neighbors.begin(), neighbors.end(), comes_before);
    return neighbors;
}

std::vector<Neighbor> KdTree::nearest(Point p, std::size_t count) const {
    count = std::min(count, size());
    if (count == 0) return {};
    const double query[2] = {p.x, p.y};
    NearestFew few(count);
    index_->tree.findNeighbors(few, query, nanoflann::SearchParams{});
    return few.kept();
}

std::vector<int> KdTree::nearest_others(std::size_t count) const {
    const std::vector<Point>& points = index_->cloud.points;
    if (points.size() < 2 || count == 0) return {};
    const std::size_t others = std::min(count, points.size() - 1);
    std::vector<int> lists;
    lists.reserve(points.size() * others);
    NearestFew few(others + 1);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double query[2] = {points[i].x, points[i].y};
        few.clear();
        index_->tree.findNeighbors(few, query, nanoflann::SearchParams{});
        const std::size_t end = lists.size() + others;
        for (const Neighbor& neighbor : few.kept()) {
            if (neighbor.index != i && lists.size() < end) lists.push_back(static_cast<int>(neighbor.index));
        }
    }
    return lists;
}

}  // namespace rinceau
