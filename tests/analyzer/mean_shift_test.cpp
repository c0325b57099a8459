#include <catch2/catch.hpp>

#include <algorithm>
#include <map>

#include "analyzer/mean_shift.h"
#include "geometry/random.h"

using namespace rinceau;

namespace {

TransformationPoint near(const TransformationPoint& center, double spread, Random& random) {
    TransformationPoint p = center;
    p.alpha = wrap_angle(p.alpha + random.uniform(-spread, spread));
    p.d += random.uniform(-spread, spread);
    p.s *= std::exp(random.uniform(-spread, spread));
    p.beta = wrap_angle(p.beta + random.uniform(-spread, spread));
    return p;
}

/// Four clusters of 60, 50, 40 and 30 points, the first about alpha = 180 degrees, the last mirrored.
std::vector<TransformationPoint> four_clusters(double spread) {
    Random random(4);
    const std::vector<TransformationPoint> centers = {{0, 0, pi, 2, 1, 0.5, false},
                                                      {0, 0, 0.4, 2, 1, -pi, false},
                                                      {0, 0, 0.4, 2, 1.5, -3, false},
                                                      {0, 0, 0.4, 2, 1, -pi, true}};
    std::vector<TransformationPoint> points;
    for (int c = 0; c < 4; ++c)
        for (int i = 0; i < 60 - 10 * c; ++i) points.push_back(near(centers[static_cast<std::size_t>(c)], spread, random));
    return points;
}

}  // namespace

TEST_CASE("mean shift recovers known clusters, across the cut of the angles too") {
    const std::vector<TransformationPoint> points = four_clusters(0.02);
    const TransformationClusters found = mean_shift(points);
    REQUIRE(found.clusters.size() == 4);
    CHECK(found.clusters[0].count == 60);
    CHECK(found.clusters[1].count == 50);
    CHECK(found.clusters[2].count == 40);
    CHECK(found.clusters[3].count == 30);
    CHECK(std::abs(wrap_angle(found.clusters[0].alpha - pi)) < 0.005);
    CHECK(std::abs(wrap_angle(found.clusters[1].beta - pi)) < 0.005);
    CHECK(found.clusters[2].s == Approx(1.5).epsilon(0.005));
    CHECK(found.clusters[3].mirrored);
    for (std::size_t i = 0; i < 60; ++i) CHECK(found.cluster_of[i] == 0);
}

TEST_CASE("the partition does not depend on the order of the points") {
    std::vector<TransformationPoint> points = four_clusters(0.06);
    for (std::size_t i = 0; i < points.size(); ++i) points[i].from = static_cast<int>(i);
    const TransformationClusters before = mean_shift(points);
    std::vector<TransformationPoint> shuffled = points;
    Random random(9);
    for (std::size_t i = shuffled.size(); i-- > 1;) std::swap(shuffled[i], shuffled[random.below(static_cast<std::uint32_t>(i + 1))]);
    const TransformationClusters after = mean_shift(shuffled);
    REQUIRE(after.clusters.size() == before.clusters.size());
    std::map<int, int> renamed;
    for (std::size_t i = 0; i < shuffled.size(); ++i) {
        const int old = before.cluster_of[static_cast<std::size_t>(shuffled[i].from)];
        CHECK(renamed.try_emplace(old, after.cluster_of[i]).first->second == after.cluster_of[i]);
    }
}

TEST_CASE("wider bandwidths join what narrow ones keep apart") {
    std::vector<TransformationPoint> points;
    for (int i = 0; i < 20; ++i) points.push_back({0, 0, 0, 1 + 0.1 * (i % 2), 1, 0, false});
    CHECK(mean_shift(points).clusters.size() == 2);
    const TransformationClusters wide = mean_shift(points, {.d = 0.5});
    REQUIRE(wide.clusters.size() == 1);
    CHECK(wide.clusters[0].d == Approx(1.05));
}

TEST_CASE("turning all angles by the same amount turns the clusters, however wide the bandwidth") {
    for (const double bandwidth : {0.05, 0.5, 3.0}) {
        const std::vector<TransformationPoint> points = four_clusters(0.02);
        const MeanShiftBandwidths bandwidths{.alpha = bandwidth, .beta = bandwidth};
        const std::size_t expected = mean_shift(points, bandwidths).clusters.size();
        for (const double turn : {1.0, 2.0, 3.0}) {
            std::vector<TransformationPoint> turned = points;
            for (TransformationPoint& p : turned) p.alpha = wrap_angle(p.alpha + turn);
            CHECK(mean_shift(turned, bandwidths).clusters.size() == expected);
        }
    }
}

TEST_CASE("a hundred thousand equal steps are one cluster, at once") {
    const std::vector<TransformationPoint> points(100'000, {0, 0, 0.5, 3, 1, 0, false});
    const TransformationClusters found = mean_shift(points);
    REQUIRE(found.clusters.size() == 1);
    CHECK(found.clusters[0].count == 100'000);
    CHECK(found.clusters[0].alpha == Approx(0.5));
}

TEST_CASE("no points, no clusters") { CHECK(mean_shift({}).clusters.empty()); }
