#include <catch2/catch.hpp>

#include "geometry/angle.h"
#include "geometry/cubic_bezier.h"
#include "geometry/polygon.h"
#include "geometry/random.h"

using namespace rinceau;

static CubicBezier random_curve(Random& random) {
    const auto point = [&] { return Point{random.uniform(-9, 9), random.uniform(-9, 9)}; };
    return {point(), point(), point(), point()};
}

TEST_CASE("the parts of a split curve run along the whole and their lengths add up") {
    Random random(1);
    for (int i = 0; i < 50; ++i) {
        const CubicBezier curve = random_curve(random);
        const double t = random.uniform(0.1, 0.9);
        const auto [before, after] = split(curve, t);
        const double s = random.uniform(0, 1);
        CHECK(abs(evaluate(before, s) - evaluate(curve, s * t)) < 1e-12);
        CHECK(abs(evaluate(after, s) - evaluate(curve, t + s * (1 - t))) < 1e-12);
        CHECK(arc_length(before) + arc_length(after) == Approx(arc_length(curve)).epsilon(1e-9));
    }
}

TEST_CASE("the derivative agrees with differences") {
    Random random(2);
    for (int i = 0; i < 50; ++i) {
        const CubicBezier curve = random_curve(random);
        const double t = random.uniform(0.01, 0.99), step = 1e-5;
        const Point difference = (evaluate(curve, t + step) - evaluate(curve, t - step)) / (2 * step);
        CHECK(abs(difference - derivative(curve, t)) < 1e-7);
    }
}

TEST_CASE("the box of a curve is that of its points and touches them on all sides") {
    Random random(3);
    for (int i = 0; i < 50; ++i) {
        const CubicBezier curve = random_curve(random);
        Box sampled;
        for (int k = 0; k <= 2000; ++k) sampled = including(sampled, evaluate(curve, k / 2000.0));
        const Box box = bounds(curve);
        CHECK(contains(grown(box, 1e-12), sampled));
        CHECK(contains(grown(sampled, 1e-4), box));
    }
}

TEST_CASE("a parabola has the box and the length of the closed form") {
    // y = x^2 for x from -1 to 1
    const CubicBezier curve{{-1, 1}, {-1.0 / 3, -1.0 / 3}, {1.0 / 3, -1.0 / 3}, {1, 1}};
    const Box box = bounds(curve);
    CHECK(box.low.y == Approx(0).margin(1e-15));
    CHECK(box.high == Point{1, 1});
    CHECK(arc_length(curve) == Approx(std::sqrt(5.0) + std::asinh(2.0) / 2).epsilon(1e-11));
}

TEST_CASE("a curve with a cusp and one that turns back on a line keep their accuracy") {
    // x = t^2 (3 - 2t) on a line from 0 to 1 and beyond: there and back
    CHECK(arc_length({{0, 0}, {1, 0}, {1, 0}, {0, 0}}) == Approx(1.5).epsilon(1e-9));
    // the semi-cubical parabola (3 t^2, 2 t^3), t from -1 to 1: length 4 (2 sqrt 2 - 1)
    const CubicBezier cusp{{3, -2}, {-1, 2}, {-1, -2}, {3, 2}};
    CHECK(arc_length(cusp) == Approx(4 * (2 * std::sqrt(2.0) - 1)).epsilon(1e-9));
    CHECK(arc_length({{4, 4}, {4, 4}, {4, 4}, {4, 4}}) == 0);
}

TEST_CASE("a flattened curve keeps to its deviation and to its end") {
    Random random(4);
    for (const double deviation : {1.0, 0.1, 0.001}) {
        const CubicBezier curve = random_curve(random);
        const std::vector<Point> points = flattened(curve, deviation);
        CHECK(points.back() == curve.to);
        double worst = 0;
        for (int k = 0; k <= 500; ++k) {
            double nearest = 1e9;
            Point from = curve.from;
            for (const Point to : points) {
                nearest = std::min(nearest, distance_to_segment(evaluate(curve, k / 500.0), from, to));
                from = to;
            }
            worst = std::max(worst, nearest);
        }
        CHECK(worst <= deviation);
    }
    CHECK(flattened({{0, 0}, {1, 0}, {2, 0}, {3, 0}}, 0.1).size() == 1);
}

TEST_CASE("arc samples integrate over the arc length") {
    // a nearly circular quarter of radius 1: length and centroid of the arc
    const double handle = 0.5522847498;
    const CubicBezier quarter{{1, 0}, {1, handle}, {handle, 1}, {0, 1}};
    double whole = 0;
    Point moment;
    for (const ArcSample& sample : arc_samples(quarter, 4)) {
        whole += sample.weight;
        moment += sample.weight * sample.at;
    }
    CHECK(whole == Approx(arc_length(quarter)).epsilon(1e-11));
    CHECK(whole == Approx(pi / 2).epsilon(3e-4));
    CHECK(moment.x == Approx(moment.y).epsilon(1e-9));
    CHECK(moment.x == Approx(1).epsilon(1e-3));
}
