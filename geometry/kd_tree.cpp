#include "geometry/kd_tree.h"

#include <algorithm>
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
    std::sort(neighbors.begin(), neighbors.end(), [](const Neighbor& a, const Neighbor& b) {
        return a.distance != b.distance ? a.distance < b.distance : a.index < b.index;
    });
    return neighbors;
}

std::vector<Neighbor> KdTree::nearest(Point p, std::size_t count) const {
    count = std::min(count, size());
    if (count == 0) return {};
    std::vector<std::size_t> indices(count);
    std::vector<double> squares(count);
    const double query[2] = {p.x, p.y};
    index_->tree.knnSearch(query, count, indices.data(), squares.data());
    // Which of several equally distant points the tree gives depends on its shape: take all of them and sort.
    double radius = 0;
    for (const std::size_t index : indices) radius = std::max(radius, abs(index_->cloud.points[index] - p));
    std::vector<Neighbor> neighbors = within(p, radius);
    neighbors.resize(std::min(neighbors.size(), count));
    return neighbors;
}

}  // namespace rinceau
