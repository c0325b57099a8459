#include <catch2/catch.hpp>

#include <algorithm>

#include "analyzer/point_symmetry.h"
#include "analyzer/redrawn.h"
#include "closed_loop/shapes.h"

using namespace rinceau;
using namespace rinceau::test;

namespace {

SymmetryGroup symmetry(const std::vector<Path>& paths, double distance = 0.002, double round_distance = 0.002) {
    const Outline outline = outline_of(paths, stroked({}, 1));
    const Descriptor d = describe(outline);
    return symmetry_of(d.moments, fine_outline(outline, d.centroid - outline.origin, d.rms_radius), distance,
                       round_distance);
}

int rotations(const SymmetryGroup& group) {
    return static_cast<int>(std::ranges::count(group.elements, false, &Similarity::mirrored));
}
int mirrors(const SymmetryGroup& group) { return static_cast<int>(group.elements.size()) - rotations(group); }

/// `count` copies of a slanted blade about the origin: turns into itself, never into its mirror image.
std::vector<Path> pinwheel(int count) {
    std::vector<Path> blades;
    for (int i = 0; i < count; ++i)
        blades.push_back(transformed({polygon({{0.2, 0}, {1, 0.1}, {0.9, 0.5}})}, rotate(two_pi * i / count))[0]);
    return blades;
}

Path open_line(const std::vector<Point>& points) {
    Path path = polygon(points);
    path.closed = false;
    return path;
}

}  // namespace

TEST_CASE("a regular polygon has the rotations and mirrors of its corners, also beyond the order of the moments") {
    for (const int corners : {3, 4, 5, 6, 7, 8, 12, 13, 16, 24, 32}) {
        const SymmetryGroup group = symmetry(regular_polygon(corners));
        CAPTURE(corners);
        CHECK_FALSE(group.continuous);
        CHECK(rotations(group) == corners);
        CHECK(mirrors(group) == corners);
    }
}

TEST_CASE("stars have the symmetry of their points") {
    for (int points = 3; points <= 9; ++points) {
        const SymmetryGroup group = symmetry(star(points));
        CHECK(rotations(group) == points);
        CHECK(mirrors(group) == points);
    }
}

TEST_CASE("rectangles and ellipses have two mirrors, lines too") {
    for (const auto& paths : {rectangle(2, 1), ellipse(0.6), bar()}) {
        const SymmetryGroup group = symmetry(paths);
        CHECK(rotations(group) == 2);
        CHECK(mirrors(group) == 2);
    }
}

TEST_CASE("four cubics that mean a circle are a circle, and so is a ring, and an ellipse is not") {
    CHECK(symmetry(circle()).continuous);
    std::vector<Path> ring = circle();
    ring.push_back(circle(0.4)[0]);
    CHECK(symmetry(ring).continuous);
    CHECK_FALSE(symmetry(ellipse(0.98)).continuous);
    CHECK(symmetry(circle(), 1e-5, 2.8e-4).continuous);      // as large as the picture
    CHECK_FALSE(symmetry(circle(), 1e-5, 1e-5).continuous);  // asked to be exact, it has the symmetry of its four arcs
    CHECK(rotations(symmetry(circle(), 1e-5, 1e-5)) == 4);
}

TEST_CASE("pinwheels turn but have no mirror") {
    for (int blades = 2; blades <= 7; ++blades) {
        const SymmetryGroup group = symmetry(pinwheel(blades));
        CHECK(rotations(group) == blades);
        CHECK(mirrors(group) == 0);
    }
}

TEST_CASE("letters: F has no symmetry, A and E one mirror, S half a turn, H both") {
    const std::vector<Path> f{open_line({{0, -1}, {0, 1}, {1, 1}}), open_line({{0, 0.2}, {0.7, 0.2}})};
    const std::vector<Path> a{open_line({{-1, -1}, {0, 1}, {1, -1}}), open_line({{-0.5, 0}, {0.5, 0}})};
    const std::vector<Path> e{open_line({{1, 1}, {0, 1}, {0, -1}, {1, -1}}), open_line({{0, 0}, {0.8, 0}})};
    const std::vector<Path> s{open_line({{1, 1}, {-1, 1}, {-1, 0}, {1, 0}, {1, -1}, {-1, -1}})};
    const std::vector<Path> h{open_line({{-1, -1}, {-1, 1}}), open_line({{1, -1}, {1, 1}}), open_line({{-1, 0}, {1, 0}})};
    const auto orders = [](const std::vector<Path>& letter) {
        const SymmetryGroup group = symmetry(letter);
        return std::pair{rotations(group), mirrors(group)};
    };
    CHECK(orders(f) == std::pair{1, 0});
    CHECK(orders(a) == std::pair{1, 1});
    CHECK(orders(e) == std::pair{1, 1});
    CHECK(orders(s) == std::pair{2, 0});
    CHECK(orders(h) == std::pair{2, 2});
}

TEST_CASE("a symmetry group is closed, and starts with the identity") {
    for (const auto& paths : {rectangle(2, 1), star(5), transformed(star(6), rotate(0.3)), pinwheel(4), hook(), leaf()}) {
        const SymmetryGroup group = symmetry(paths);
        CHECK(group.elements.front() == Similarity{});
        for (const Similarity& a : group.elements)
            for (const Similarity& b : group.elements) {
                const Similarity product = a * b;
                CHECK(std::ranges::any_of(group.elements, [&](const Similarity& c) {
                    return c.mirrored == product.mirrored && abs(c.linear - product.linear) < 1e-9;
                }));
            }
    }
}

TEST_CASE("a small flaw breaks a symmetry") {
    std::vector<Path> flawed = regular_polygon(6);
    flawed[0].segments[1] = line_to(1.05 * flawed[0].segments[1].to);
    CHECK(rotations(symmetry(flawed)) == 1);
    CHECK(mirrors(symmetry(flawed)) == 1);
}
