#include <catch2/catch.hpp>

#include <vector>

#include "analyzer/group_frame.h"
#include "analyzer/redrawn.h"
#include "analyzer/rule_sets.h"

using namespace rinceau;
using namespace rinceau::test;

namespace {

constexpr double equal = 1e-3;  // of the child's size, and radians

/// The parts 0, 1, .. are looks with these symmetries; the group's children stand in these places.
Part group_of(const std::vector<SymmetryGroup>& looks, std::vector<Child> children) {
    RuleSet rules;
    for (std::size_t look = 0; look < looks.size(); ++look) rules.parts.push_back(look_part(static_cast<int>(look), looks[look]));
    std::vector<Similarity> poses;
    for (const Child& child : children) poses.push_back(child.pose);
    poses = centred(poses);
    for (std::size_t k = 0; k < children.size(); ++k) children[k].pose = poses[k];
    Part part;
    part.rule = 0;
    part.count = static_cast<int>(children.size());
    part.children = children;
    return completed_part(rules, part, equal, equal);
}

std::size_t order_of_row(const SymmetryGroup& look, const Similarity& step) {
    std::vector<Child> children;
    Similarity pose;
    for (int k = 0; k < 5; ++k, pose = pose * step) children.push_back({0, pose});
    return group_of({look}, children).symmetry.elements.size();
}

Part ring_of(const SymmetryGroup& look, int count) {
    std::vector<Child> children;
    for (int k = 0; k < count; ++k) children.push_back({0, rotate(two_pi * k / count) * translate({0, 5})});
    return group_of({look}, children);
}

}  // namespace

TEST_CASE("a row has the symmetries of its elements that turn the row into itself") {
    const Similarity across = translate({3, 0});
    CHECK(order_of_row(cyclic(1), across) == 1);
    CHECK(order_of_row(cyclic(2), across) == 2);
    CHECK(order_of_row(cyclic(3), across) == 1);
    CHECK(order_of_row(dihedral(4), across) == 4);            // squares: two axes
    CHECK(order_of_row(dihedral(1), across) == 2);            // leaves side by side: the mirror image about the middle one
    CHECK(order_of_row(dihedral(1), translate({0, 3})) == 2);  // leaves in a line: about the line
    CHECK(order_of_row(dihedral(1), translate({2, 3})) == 1);  // slanting
    CHECK(order_of_row(continuous(), translate({2, 3})) == 4);
    CHECK(order_of_row(dihedral(4), translate({3, 0}) * scale_by(0.9)) == 2);  // about its line only
}

TEST_CASE("a closed ring has all turns, and all mirror images if its elements have one along the radius") {
    CHECK(ring_of(cyclic(1), 12).symmetry.elements.size() == 12);
    CHECK(ring_of(dihedral(1), 8).symmetry.elements.size() == 16);
    CHECK(ring_of(continuous(), 12).symmetry.elements.size() == 24);
    CHECK(ring_of(dihedral(1, 0.3), 8).symmetry.elements.size() == 8);
    CHECK(ring_of(cyclic(1), 5).symmetry.elements.front() == Similarity{});
}

TEST_CASE("every symmetry of a ring turns it into itself") {
    const Part ring = ring_of(dihedral(1), 9);
    const SymmetryGroup leaf = dihedral(1);
    for (const Similarity& s : ring.symmetry.elements) {
        CHECK(abs(s.linear) == Approx(1));
        CHECK(abs(s.translation) == 0);
        for (const Child& child : ring.children) {
            double nearest = HUGE_VAL;
            for (const Child& other : ring.children) nearest = std::min(nearest, distance(s * child.pose, other.pose, leaf));
            CHECK(nearest < equal);
        }
    }
}

TEST_CASE("a bullseye has no direction, unless something in it has") {
    CHECK(group_of({continuous(), continuous()}, {{0, {}}, {1, scale_by(2)}}).symmetry.continuous);
    const Part squared = group_of({continuous(), dihedral(4)}, {{0, {}}, {1, scale_by(2)}});
    CHECK_FALSE(squared.symmetry.continuous);
    CHECK(squared.symmetry.elements.size() == 8);
}

TEST_CASE("a tuple of different things has no symmetry but a common axis") {
    const Similarity right = translate({4, 0});
    CHECK(group_of({cyclic(1), cyclic(1)}, {{0, {}}, {1, right}}).symmetry.elements.size() == 1);
    CHECK(group_of({continuous(), continuous()}, {{0, {}}, {1, right}}).symmetry.elements.size() == 2);
    CHECK(group_of({continuous(), dihedral(1)}, {{0, {}}, {1, right}}).symmetry.elements.size() == 1);
    CHECK(group_of({continuous(), dihedral(1)}, {{0, {}}, {1, translate({0, 4})}}).symmetry.elements.size() == 2);
    // Two mirror images face each other.
    CHECK(group_of({cyclic(1)}, {{0, {}}, {0, right * mirror_about_heading()}}).symmetry.elements.size() == 2);
}

TEST_CASE("a group counts its leaves and reaches as far as they do") {
    const Part ring = ring_of(cyclic(1), 7);
    CHECK(ring.leaves == 7);
    CHECK(ring.radius == Approx(6));
}

TEST_CASE("the origin of a group is the mean of its children's, their poses to each other stay") {
    Random random(5);
    std::vector<Similarity> poses;
    for (int k = 0; k < 6; ++k) poses.push_back(random_similarity(random));
    const std::vector<Similarity> moved = centred(poses);
    Point sum;
    for (const Similarity& pose : moved) sum += pose.translation;
    CHECK(abs(sum) < 1e-9);
    for (std::size_t k = 0; k < poses.size(); ++k) {
        CHECK(moved[k].linear == poses[k].linear);
        CHECK(distance(inverse(moved[0]) * moved[k], inverse(poses[0]) * poses[k]) < 1e-9 * (1 + abs(poses[k].translation)));
    }
}

TEST_CASE("the pose of a group is where its members are, also mirrored, and as exact as they are") {
    Random random(6);
    for (int trial = 0; trial < 40; ++trial) {
        const Similarity wanted = random_similarity(random);
        const std::size_t count = 1 + random.below(6);
        std::vector<Similarity> children, frames, shaken;
        std::vector<double> radii;
        for (std::size_t k = 0; k < count; ++k) {
            children.push_back({polar(random.uniform(0.5, 2), random.uniform(-pi, pi)), {random.uniform(-5, 5), random.uniform(-5, 5)}, random.below(2) == 1});
            frames.push_back(wanted * children.back());
            shaken.push_back(frames.back() * translate({random.uniform(-1e-3, 1e-3), random.uniform(-1e-3, 1e-3)}));
            radii.push_back(random.uniform(0.5, 3));
        }
        const double size = scale_of(wanted) + abs(wanted.translation);
        CHECK(distance(group_pose(children, frames, radii), wanted) < 1e-9 * size);
        CHECK(distance(group_pose(children, shaken, radii), wanted) < 0.03 * scale_of(wanted));
    }
}
