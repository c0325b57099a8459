#include "growth/surface/collision_space.h"

#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <cmath>

#include "geometry/angle.h"
#include "geometry/random.h"
#include "growth/surface/convex_overlap.h"
#include "growth/surface/shape_sources.h"
#include "growth/surface/solids_overlap.h"

namespace rinceau {
namespace {

std::array<SpacePoint, 3> random_axes(Random& random) {
    const SpacePoint z = unit({random.normal(), random.normal(), random.normal()});
    const SpacePoint x = unit(cross(z, SpacePoint{random.normal(), random.normal(), random.normal()}));
    return {x, cross(z, x), z};
}

SpacePoint random_point(Random& random, double size) {
    return {random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}

CollisionBody random_box(Random& random, double room) {
    CollisionBody body;
    body.centre = random_point(random, room);
    body.axes = random_axes(random);
    body.half = {random.uniform(0.1, 0.5), random.uniform(0.1, 0.5), random.uniform(0.1, 0.5)};
    body.normal = body.axes[2];
    return body;
}

/// Convex, about the middle of its box.
std::vector<Point> random_polygon(Random& random) {
    std::vector<Point> ring;
    const int corners = 3 + static_cast<int>(random.below(9));
    for (int i = 0; i < corners; ++i) ring.push_back(0.5 * polar(1, two_pi * (i + random.uniform(0, 0.8)) / corners));
    return ring;
}

GrammarShape prism(std::vector<Point> ring) {
    GrammarShape shape;
    shape.low = {0, 0, 0};
    shape.high = {0, 0, 0.4};
    Box box;
    for (const Point p : ring) box = including(box, p);
    shape.low = {box.low.x, box.low.y, 0};
    shape.high = {box.high.x, box.high.y, 0.4};
    shape.outline = {ring};
    shape.hull = std::move(ring);
    shape.collide = CollideAs::hull;
    return shape;
}

/// The corners of the prism over the body's hull or rectangle.
std::vector<SpacePoint> corners_of(const CollisionBody& body) {
    std::vector<Point> ring{
        {-body.half.x, -body.half.y}, {body.half.x, -body.half.y}, {body.half.x, body.half.y}, {-body.half.x, body.half.y}};
    if (body.collide == CollideAs::hull) {
        ring.clear();
        for (const Point p : body.hull)
            ring.push_back(Point{p.x * body.outline_scale.x, p.y * body.outline_scale.y} + body.outline_shift);
    }
    std::vector<SpacePoint> corners;
    for (const double z : {-body.half.z, body.half.z})
        for (const Point p : ring)
            corners.push_back(body.centre + p.x * body.axes[0] + p.y * body.axes[1] + z * body.axes[2]);
    return corners;
}

btConvexHullShape bullet_hull(const CollisionBody& body) {
    btConvexHullShape hull;
    for (const SpacePoint p : corners_of(body)) hull.addPoint(btVector3(btScalar(p.x), btScalar(p.y), btScalar(p.z)), false);
    hull.recalcLocalAabb();
    hull.setMargin(0);
    return hull;
}

/// Bullet's distance; negative if they overlap.
double bullet_distance(const CollisionBody& a, const CollisionBody& b) {
    const btConvexHullShape first = bullet_hull(a), second = bullet_hull(b);
    btVoronoiSimplexSolver simplex;
    btGjkEpaPenetrationDepthSolver depth;
    btGjkPairDetector detector(&first, &second, &simplex, &depth);
    btGjkPairDetector::ClosestPointInput input;
    input.m_transformA.setIdentity();
    input.m_transformB.setIdentity();
    btPointCollector result;
    detector.getClosestPoints(input, result, nullptr);
    return result.m_hasResult ? double(result.m_distance) : 1e9;
}

/// Where both answers are clear of the dead band they must agree.
void check_against_bullet(const CollisionBody& a, const CollisionBody& b, int& overlaps) {
    constexpr double dead_band = 1e-3;
    const double size = std::min(radius_of(a), radius_of(b));
    const double distance = bullet_distance(a, b);
    const bool ours = bodies_overlap(a, b, 1, 1);
    overlaps += ours;
    INFO("Bullet's distance " << distance);
    if (distance > dead_band * size) CHECK_FALSE(ours);
    if (distance < -dead_band * size) CHECK(ours);
}

}  // namespace

TEST_CASE("boxes overlap where Bullet says so") {
    Random random(5);
    int overlaps = 0;
    constexpr int pairs = 3000;
    for (int i = 0; i < pairs; ++i) check_against_bullet(random_box(random, 0.5), random_box(random, 0.5), overlaps);
    CHECK(overlaps > pairs / 5);
    CHECK(overlaps < 4 * pairs / 5);
}

TEST_CASE("hulls and boxes overlap where Bullet says so") {
    Random random(6);
    int overlaps = 0;
    constexpr int pairs = 3000;
    for (int i = 0; i < pairs; ++i) {
        const GrammarShape one = prism(random_polygon(random)), other = prism(random_polygon(random));
        const SpacePoint size{random.uniform(0.4, 1.5), random.uniform(0.4, 1.5), random.uniform(0.4, 1.5)};
        const auto axes = random_axes(random);
        const CollisionBody a = collision_body(one, random_point(random, 0.45), axes, size, axes[2]);
        const auto turned = random_axes(random);
        CollisionBody b = collision_body(other, random_point(random, 0.45), turned, size, axes[2]);
        if (i % 3 == 0) b.collide = CollideAs::box;
        check_against_bullet(a, b, overlaps);
    }
    CHECK(overlaps > pairs / 5);
    CHECK(overlaps < 4 * pairs / 5);
}

TEST_CASE("boxes by support points and by separating axes agree") {
    Random random(7);
    int overlaps = 0;
    for (int i = 0; i < 5000; ++i) {
        const CollisionBody a = random_box(random, 0.35), b = random_box(random, 0.35);
        CHECK(boxes_overlap(a, b, 1, 1) == convex_bodies_overlap(a, b, 1, 1));
        overlaps += boxes_overlap(a, b, 1, 1);
    }
    CHECK(overlaps > 1000);
}

TEST_CASE("what touches does not overlap, in any position") {
    Random random(8);
    for (int i = 0; i < 500; ++i) {
        CollisionBody a = random_box(random, 10);
        if (i % 2 == 1) a.collide = CollideAs::disc, a.half.y = a.half.x;
        CollisionBody b = a;
        b.centre = a.centre + 2 * a.half.x * a.axes[0];  // side to side
        CHECK_FALSE(bodies_overlap(a, b, 1, 1));
        b.centre = a.centre + 1.999 * a.half.x * a.axes[0];
        CHECK(bodies_overlap(a, b, 1, 1));
        b.centre = a.centre + 2 * a.half.z * a.axes[2];  // one on the other
        CHECK_FALSE(bodies_overlap(a, b, 1, 1));
    }
}

TEST_CASE("round shapes collide by their distance where boxes would at their corners") {
    GrammarShape disc;
    disc.low = {-0.5, -0.5, 0};
    disc.high = {0.5, 0.5, 0.2};
    disc.collide = CollideAs::disc;
    const SpacePoint up{0, 0, 1};
    for (int i = 0; i < 12; ++i) {
        const Point x = polar(1, 0.4 * i), to = polar(1, 1.1 * i);
        const std::array<SpacePoint, 3> axes{{{1, 0, 0}, {0, 1, 0}, up}}, turned{{{x.x, x.y, 0}, {-x.y, x.x, 0}, up}};
        const auto at = [&](double distance) {
            return collision_body(disc, {distance * to.x, distance * to.y, 0}, turned, {1, 1, 1}, up);
        };
        const CollisionBody a = collision_body(disc, {}, axes, {1, 1, 1}, up);
        CHECK(bodies_overlap(a, at(0.999), 1, 1));
        CHECK_FALSE(bodies_overlap(a, at(1.001), 1, 1));
        // Shrunk by 2 % each.
        CHECK_FALSE(bodies_overlap(a, at(0.985), 0.98, 0.98));
        CHECK(bodies_overlap(a, at(0.975), 0.98, 0.98));
        // Halved, as kin.
        CHECK_FALSE(bodies_overlap(a, at(0.51), 0.5, 0.5));
    }
    // Ellipses: along the long axis they meet at its length, across at its width.
    const std::array<SpacePoint, 3> axes{{{1, 0, 0}, {0, 1, 0}, up}};
    const CollisionBody ellipse = collision_body(disc, {}, axes, {2, 0.5, 1}, up);
    const auto beside = [&](double dx, double dy) { return collision_body(disc, {dx, dy, 0}, axes, {2, 0.5, 1}, up); };
    CHECK(bodies_overlap(ellipse, beside(1.99, 0), 1, 1));
    CHECK_FALSE(bodies_overlap(ellipse, beside(2.01, 0), 1, 1));
    CHECK(bodies_overlap(ellipse, beside(0, 0.49), 1, 1));
    CHECK_FALSE(bodies_overlap(ellipse, beside(0, 0.51), 1, 1));
    CHECK_FALSE(bodies_overlap(ellipse, beside(1.5, 0.36), 1, 1));  // their boxes would
}

TEST_CASE("balls collide as balls, also turned out of the surface") {
    GrammarShape ball;
    ball.low = {-0.5, -0.5, -0.5};
    ball.high = {0.5, 0.5, 0.5};
    ball.collide = CollideAs::disc;
    ball.rim = 1;
    Random random(9);
    for (int i = 0; i < 300; ++i) {
        const auto axes = random_axes(random), turned = random_axes(random);
        const SpacePoint to = unit({random.normal(), random.normal(), random.normal()});
        const CollisionBody a = collision_body(ball, {}, axes, {1, 1, 1}, axes[2]);
        CollisionBody b = collision_body(ball, 0.999 * to, turned, {1, 1, 1}, axes[2]);
        CHECK(bodies_overlap(a, b, 1, 1));
        b.centre = 1.001 * to;
        CHECK_FALSE(bodies_overlap(a, b, 1, 1));
    }
}

TEST_CASE("outlines that are not convex may lie in each other's bays") {
    const Region bay{
        {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {0.3, 0.5}, {0.3, -0.3}, {-0.3, -0.3}, {-0.3, 0.5}, {-0.5, 0.5}}};
    GrammarShape cup;
    cup.low = {-0.5, -0.5, 0};
    cup.high = {0.5, 0.5, 0.1};
    cup.outline = bay;
    cup.collide = CollideAs::outline;
    GrammarShape peg = cup;
    peg.outline = {{{-0.25, -0.5}, {0.25, -0.5}, {0.25, 0.5}, {-0.25, 0.5}}};
    peg.low.x = -0.25;
    peg.high.x = 0.25;
    const std::array<SpacePoint, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    const auto up = axes[2];
    const CollisionBody a = collision_body(cup, {}, axes, {1, 1, 1}, up);
    const auto peg_at = [&](double x, double y, const auto& frame) {
        return collision_body(peg, {x, y, 0}, frame, {1, 1, 1}, up);
    };
    CHECK_FALSE(bodies_overlap(a, peg_at(0, 0.25, axes), 1, 1));
    CHECK_FALSE(bodies_overlap(a, peg_at(0, 0.2, axes), 1, 1));  // touches the ground of the bay
    CHECK(bodies_overlap(a, peg_at(0, 0.19, axes), 1, 1));
    CHECK(bodies_overlap(a, peg_at(0.06, 0.25, axes), 1, 1));
    // Upside down it fits as well; tilted a little the answer stays.
    const std::array<SpacePoint, 3> tilted{{unit({1, 0, 0.1}), {0, 1, 0}, unit({-0.1, 0, 1})}};
    CHECK_FALSE(bodies_overlap(a, peg_at(0, 0.25, tilted), 1, 1));
    // Wholly inside of a hole or of the ink.
    GrammarShape frame = cup;
    frame.outline = {{{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}},
                     {{-0.4, -0.4}, {-0.4, 0.4}, {0.4, 0.4}, {0.4, -0.4}}};
    const CollisionBody around = collision_body(frame, {}, axes, {1, 1, 1}, up);
    const auto small = [&](double x) { return collision_body(cup, {x, 0, 0}, axes, {0.05, 0.05, 1}, up); };
    CHECK_FALSE(bodies_overlap(around, small(0), 1, 1));
    CHECK(bodies_overlap(around, small(0.45), 1, 1));
}

TEST_CASE("shapes on both faces of a thin sheet do not collide through it, in a cleft they do") {
    GrammarShape ball;
    ball.low = {-0.5, -0.5, -0.5};
    ball.high = {0.5, 0.5, 0.5};
    const std::array<SpacePoint, 3> up{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, down{{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}}};
    const CollisionBody above = collision_body(ball, {0, 0, 0}, up, {1, 1, 1}, up[2]);
    CHECK_FALSE(bodies_overlap(above, collision_body(ball, {0.1, 0, -0.1}, down, {1, 1, 1}, down[2]), 1, 1));
    CHECK(bodies_overlap(above, collision_body(ball, {0.1, 0, 0.4}, down, {1, 1, 1}, down[2]), 1, 1));
    // The same two on one face.
    CHECK(bodies_overlap(above, collision_body(ball, {0.1, 0, -0.1}, up, {1, 1, 1}, up[2]), 1, 1));
}

TEST_CASE("what lies flat collides with what lies on it") {
    GrammarShape leaf;
    leaf.low = {-0.5, -0.5, 0};
    leaf.high = {0.5, 0.5, 0};
    const std::array<SpacePoint, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    const CollisionBody a = collision_body(leaf, {}, axes, {1, 1, 1}, axes[2]);
    CHECK(bodies_overlap(a, collision_body(leaf, {0.9, 0, 0}, axes, {1, 1, 1}, axes[2]), 1, 1));
    CHECK_FALSE(bodies_overlap(a, collision_body(leaf, {1.1, 0, 0}, axes, {1, 1, 1}, axes[2]), 1, 1));
}

TEST_CASE("the space finds the first overlap that all pairs give, with sizes far apart, and kin halved") {
    Random random(10);
    CollisionSpace space;
    std::vector<CollisionBody> placed;
    int refused = 0;
    for (int i = 0; i < 1500; ++i) {
        CollisionBody body = random_box(random, 4);
        const double scale = std::exp(random.uniform(-6, 1.2));
        body.half = scale * body.half;
        if (i % 3 == 0) body.collide = CollideAs::disc;
        std::vector<int> kin;
        for (int k = 0; k < 6 && k < static_cast<int>(placed.size()); ++k)
            kin.push_back(static_cast<int>(random.below(static_cast<std::uint32_t>(placed.size()))));
        std::optional<int> first;
        for (int j = 0; j < static_cast<int>(placed.size()) && !first; ++j) {
            const bool related = std::find(kin.begin(), kin.end(), j) != kin.end();
            const double shrink = related ? 0.49 : 0.98;
            if (bodies_overlap(body, placed[static_cast<std::size_t>(j)], shrink, shrink)) first = j;
        }
        REQUIRE(space.overlap(body, kin) == first);
        refused += first.has_value();
        if (!first || i % 7 == 0) {
            CHECK(space.add(body) == static_cast<int>(placed.size()));
            placed.push_back(body);
        }
    }
    CHECK(refused > 100);
    CHECK(placed.size() > 300);
    const SpacePoint p{0.5, 1, -1};
    std::vector<int> near;
    for (std::size_t i = 0; i < placed.size(); ++i)
        if (abs(placed[i].centre - p) <= 1.5) near.push_back(static_cast<int>(i));
    CHECK(near.size() > 5);
    CHECK(space.near(p, 1.5) == near);
}

TEST_CASE("taking bodies back gives the state from before") {
    Random random(11);
    CollisionSpace space, twin;
    for (int i = 0; i < 700; ++i) {
        const CollisionBody body = random_box(random, 5);
        space.add(body);
        if (i < 300) twin.add(body);
    }
    space.remove_from(300);
    CHECK(space.size() == 300);
    for (int i = 0; i < 500; ++i) {
        const CollisionBody body = random_box(random, 5);
        REQUIRE(space.overlap(body) == twin.overlap(body));
        CHECK(space.near(body.centre, 1) == twin.near(body.centre, 1));
        CHECK(space.add(body) == twin.add(body));
    }
    space.remove_from(0);
    CHECK(space.size() == 0);
    CHECK_FALSE(space.overlap(random_box(random, 5)));
}

TEST_CASE("near-zero boxes do not make the others slow") {
    Random random(12);
    const auto seconds = [&](bool tiny_first, double tiny) {
        CollisionSpace space;
        const auto start = std::chrono::steady_clock::now();
        constexpr int count = 6000;
        for (int i = 0; i < count; ++i) {
            CollisionBody body = random_box(random, 8);
            if (tiny_first ? i < count / 2 : i % 2 == 1) body.half = tiny * body.half;
            space.overlap(body);
            space.add(body);
        }
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    const double ordinary = seconds(false, 1);
    CHECK(seconds(false, 1e-12) < 20 * ordinary + 0.5);
    CHECK(seconds(true, 1e-12) < 20 * ordinary + 0.5);
    CHECK(seconds(false, 0) < 20 * ordinary + 0.5);
    CHECK(seconds(true, 1e-300) < 20 * ordinary + 0.5);
}

TEST_CASE("what the space lets stand does not overlap as it is drawn, by another method") {
    Random random(13);
    const auto made = [](const std::string& kind, CollideAs collide) {
        GrammarShape shape = make_shape({.name = kind, .kind = kind}, {}, {});
        shape.collide = collide;
        return shape;
    };
    const std::vector<GrammarShape> shapes{made("box", CollideAs::box),      made("cylinder", CollideAs::box),
                                           made("torus", CollideAs::disc),   made("sphere", CollideAs::disc),
                                           made("star", CollideAs::outline), made("leaf", CollideAs::hull),
                                           made("prism", CollideAs::hull),   made("arrow", CollideAs::outline)};
    CollisionSpace space;
    std::vector<PlacedSolid> standing;
    int refused = 0, refused_and_apart = 0;
    for (int i = 0; i < 1200; ++i) {
        const GrammarShape& shape = shapes[random.below(static_cast<std::uint32_t>(shapes.size()))];
        // About a sphere, upright.
        const SpacePoint normal = unit({random.normal(), random.normal(), random.normal()});
        const SpacePoint x = unit(cross(normal, SpacePoint{random.normal(), random.normal(), random.normal()}));
        const double size = random.uniform(0.1, 0.3);
        const PlacedSolid solid{
            &shape, normal, {x, cross(normal, x), normal}, {size, random.uniform(0.5, 1) * size, 0.5 * size}};
        const bool overlap = space.overlap(collision_body(shape, normal, solid.axes, solid.size, normal)).has_value();
        const bool drawn = std::any_of(standing.begin(), standing.end(), [&](const PlacedSolid& other) {
            return solids_overlap(solid, other, 1 - 0.02 - 1e-3);
        });
        if (!overlap) CHECK_FALSE(drawn);
        refused += overlap;
        refused_and_apart += overlap && !drawn;
        if (overlap) continue;
        space.add(collision_body(shape, normal, solid.axes, solid.size, normal));
        standing.push_back(solid);
    }
    CHECK(standing.size() > 80);
    CHECK(refused > 500);
    // Bodies are somewhat larger than what they stand for, not much.
    CHECK(refused_and_apart < refused / 10);
}

}  // namespace rinceau
