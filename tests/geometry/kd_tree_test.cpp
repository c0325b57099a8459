#include <catch2/catch.hpp>

#include <algorithm>

#include "geometry/kd_tree.h"
#include "geometry/random.h"

using namespace rinceau;

static std::vector<Neighbor> sorted_by_distance(const std::vector<Point>& points, Point p) {
    std::vector<Neighbor> all;
    for (std::size_t i = 0; i < points.size(); ++i) all.push_back({i, abs(points[i] - p)});
    std::stable_sort(all.begin(), all.end(), [](const Neighbor& a, const Neighbor& b) { return a.distance < b.distance; });
    return all;
}

TEST_CASE("the tree agrees with looking at all points, ties and equal points included") {
    Random random(6);
    std::vector<Point> points;
    // whole coordinates: many ties, many points on one another
    for (int i = 0; i < 400; ++i) points.push_back({std::floor(random.uniform(0, 12)), std::floor(random.uniform(0, 12))});
    const KdTree tree(points);
    CHECK(tree.size() == points.size());
    for (int i = 0; i < 50; ++i) {
        const Point p{std::floor(random.uniform(0, 12)), random.uniform(0, 12)};
        std::vector<Neighbor> expected = sorted_by_distance(points, p);
        const std::size_t count = 1 + random.below(30);
        const double radius = std::floor(random.uniform(0, 5));
        const std::vector<Neighbor> nearest(expected.begin(), expected.begin() + static_cast<std::ptrdiff_t>(count));
        CHECK(tree.nearest(p, count) == nearest);
        std::erase_if(expected, [&](const Neighbor& n) { return n.distance > radius; });
        CHECK(tree.within(p, radius) == expected);
    }
}

TEST_CASE("the lists of nearest others are those that the tree finds one by one") {
    Random random(8);
    std::vector<Point> points;
    for (int i = 0; i < 300; ++i) points.push_back({std::floor(random.uniform(0, 9)), std::floor(random.uniform(0, 9))});
    const KdTree tree(points);
    constexpr std::size_t count = 7;
    const std::vector<int> lists = tree.nearest_others(count);
    REQUIRE(lists.size() == count * points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        std::vector<Neighbor> expected = sorted_by_distance(points, points[i]);
        std::erase_if(expected, [&](const Neighbor& n) { return n.index == i; });
        for (std::size_t k = 0; k < count; ++k) CHECK(static_cast<std::size_t>(lists[count * i + k]) == expected[k].index);
    }
    CHECK(KdTree(std::vector<Point>{{0, 0}, {1, 0}}).nearest_others(5) == std::vector<int>{1, 0});
    CHECK(KdTree(std::vector<Point>{{0, 0}}).nearest_others(5).empty());
}

TEST_CASE("a point at exactly the radius is within it") {
    const std::vector<Point> points{{3, 4}, {0.1, 0.2}};
    const KdTree tree(points);
    CHECK(tree.within({0, 0}, 5).size() == 2);
    CHECK(tree.within({3, 4}, 0) == std::vector<Neighbor>{{0, 0}});
    CHECK(tree.within({0, 0}, -1).empty());
}

TEST_CASE("an empty tree has no neighbours and more are never given than there are") {
    const KdTree none(std::vector<Point>{});
    CHECK(none.nearest({0, 0}, 3).empty());
    CHECK(none.within({0, 0}, 1e300).empty());
    const std::vector<Point> two{{0, 0}, {1, 0}};
    CHECK(KdTree(two).nearest({0, 0}, 9).size() == 2);
}
