#include <catch2/catch.hpp>

#include <algorithm>

#include "analyzer/spaces_report.h"
#include "closed_loop/shapes.h"

using namespace rinceau;
using namespace rinceau::test;

namespace {

/// Hooks along a chain of equal steps +(alpha) f(d) *(s) +(beta), d in hooks' rms radii, and a leaf apart.
Scene chain(int count, double alpha, double d, double s, double beta) {
    Scene scene{{{-200, -200}, {200, 200}}, true, {}};
    const Element original = element(hook(), filled({}));
    const Similarity unit = group_similar_elements(Scene{scene.viewport, true, {original}}).instances[0].pose;
    const Similarity step = rotate(alpha) * translate({0, d}) * scale_by(s) * rotate(beta);
    Similarity pose;
    for (int i = 0; i < count; ++i) {
        scene.elements.push_back(placed(original, unit * pose * inverse(unit)));
        pose = pose * step;
    }
    scene.elements.push_back(placed(element(leaf(), filled({})), translate({-50, -50})));
    return scene;
}

}  // namespace

TEST_CASE("the steps of a chain are one point of its space, in turtle terms") {
    const Instancing found = group_similar_elements(chain(12, radians(20), 3, 0.95, radians(-5)));
    const std::vector<TransformationSpace> spaces = fill_transformation_spaces(found);
    REQUIRE(spaces.size() == 3);  // hook-hook, hook-leaf, leaf-hook
    CHECK(spaces[0].points.size() == 12 * 11);
    CHECK(spaces[1].points.size() == 12);
    int steps = 0;
    for (const TransformationPoint& p : spaces[0].points) {
        if (p.to != p.from + 1) continue;
        ++steps;
        CHECK(p.alpha == Approx(radians(20)));
        CHECK(p.d == Approx(3));
        CHECK(p.s == Approx(0.95));
        CHECK(p.beta == Approx(radians(-5)));
        CHECK_FALSE(p.mirrored);
    }
    CHECK(steps == 11);
    const TransformationClusters clusters = mean_shift(spaces[0].points);
    CHECK(std::ranges::count(clusters.clusters, 11, &TransformationCluster::count) == 2);  // steps on, steps back
}

TEST_CASE("straight ahead is +y, and a place without advance has no direction") {
    const TransformationPoint ahead = to_transformation_point(Similarity{}, translate({0, 2}));
    CHECK(ahead.alpha == Approx(0).margin(1e-12));
    CHECK(ahead.d == Approx(2));
    const TransformationPoint left = to_transformation_point(scale_by(2), translate({-6, 0}));
    CHECK(left.alpha == Approx(pi / 2));
    CHECK(left.d == Approx(3));
    CHECK(left.s == Approx(0.5));
    CHECK(left.beta == Approx(-pi / 2));
    const TransformationPoint spin = to_transformation_point(Similarity{}, rotate(1));
    CHECK(spin.alpha == 0);
    CHECK(spin.d == 0);
    CHECK(spin.beta == Approx(1));
}

TEST_CASE("many instances are paired with their neighbours only") {
    Scene scene{{{0, 0}, {100, 100}}, true, {}};
    for (int i = 0; i < 100; ++i)
        scene.elements.push_back(placed(element(hook(), filled({})), translate({10.0 * (i % 10), 10.0 * (i / 10)})));
    const Instancing found = group_similar_elements(scene);
    const std::vector<TransformationSpace> spaces = fill_transformation_spaces(found);
    REQUIRE(spaces.size() == 1);
    CHECK(spaces[0].points.size() == 800);
    const TransformationClusters clusters = mean_shift(spaces[0].points);
    CHECK(clusters.clusters[0].count >= 90);  // each of the four directions of the lattice has 90 steps
    CHECK(clusters.clusters[3].count >= 90);
}

TEST_CASE("the table has a line for every point and the picture a plot for every space") {
    const std::vector<ClusteredSpace> spaces =
        cluster_spaces(fill_transformation_spaces(group_similar_elements(chain(5, 0.3, 3, 1, 0))));
    const std::vector<std::string> names{"A", "B<"};
    const std::string csv = spaces_csv(spaces, names);
    CHECK(std::ranges::count(csv, '\n') == 1 + 5 * 4 + 5 + 5);
    CHECK(csv.find("A,A,0,1,") != std::string::npos);
    const std::string svg = spaces_svg(spaces, names);
    CHECK(svg.find("A to B&lt;: 5 pairs") != std::string::npos);
    CHECK(svg.find("nan") == std::string::npos);
    const std::string only_one = spaces_svg(spaces, names, 1);
    CHECK(only_one.find("A to A") != std::string::npos);
    CHECK(only_one.find("A to B") == std::string::npos);
}
