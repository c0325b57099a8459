// Directions between strokes.

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "geometry/angle.h"
#include "growth/flow_field.h"
#include "scene/input_error.h"

namespace rinceau {
namespace {

const Box canvas{{0, 0}, {100, 100}};

Polyline drawn(const std::function<Point(double)>& at) {
    constexpr int corners = 200;
    Polyline line;
    for (int i = 0; i <= corners; ++i) line.push_back(at(static_cast<double>(i) / corners));
    return line;
}

Polyline circle(Point middle, double radius) {
    return drawn([=](double t) { return middle + polar(radius, two_pi * t); });
}

/// The line of a family of waves, one above the other, all with the same direction at the same x.
Polyline wave(double y) {
    return drawn([=](double t) { return Point{100 * t, y + 12 * std::sin(two_pi * t)}; });
}

double angle_between(Complex a, Complex b) { return std::abs(degrees(arg(a * conj(b)))); }
double angle_between_lines(Complex a, Complex b) { return std::min(angle_between(a, b), angle_between(a, -b)); }

}  // namespace

TEST_CASE("a stroke that was held out is met within a degree") {
    const FlowField field =
        make_flow_field(std::vector{wave(10), wave(30), wave(50), wave(70), wave(90)}, canvas, {.step = 1}, "strokes");
    double sum = 0;
    const Polyline held_out = wave(40);
    for (std::size_t i = 1; i < held_out.size(); ++i) {
        const double off =
            angle_between(direction_at(field, 0.5 * (held_out[i] + held_out[i - 1])), held_out[i] - held_out[i - 1]);
        sum += off;
        CHECK(off < 2);
    }
    CHECK(sum / static_cast<double>(held_out.size() - 1) < 1);
    CHECK(singular_points(field).empty());
}

TEST_CASE("the field follows its own strokes") {
    const std::vector<Polyline> strokes{wave(30), {{10, 80}, {90, 70}}};
    const FlowField field = make_flow_field(strokes, canvas, {.step = 1}, "strokes");
    for (const Polyline& stroke : strokes) {
        for (std::size_t i = 1; i < stroke.size(); ++i)
            CHECK(angle_between(direction_at(field, 0.5 * (stroke[i] + stroke[i - 1])), stroke[i] - stroke[i - 1]) < 1.5);
    }
}

TEST_CASE("a straight stroke is the same direction everywhere") {
    for (const Polyline& stroke : {Polyline{{5, 5}, {25, 10}}, Polyline{{40, 40}, {40, 40.001}}}) {
        const FlowField field = make_flow_field(std::vector<Polyline>{stroke}, canvas, {.step = 5}, "strokes");
        for (const Point p : {Point{0, 0}, Point{100, 0}, Point{33, 71}, Point{100, 100}, Point{-500, 900}})
            CHECK(angle_between(direction_at(field, p), stroke[1] - stroke[0]) < 1e-3);
    }
}

TEST_CASE("a round stroke turns about exactly one singular point, wherever the table's nodes lie") {
    for (const Point middle : {Point{50, 50}, Point{50.5, 50.5}, Point{20, 71.3}}) {
        for (const bool directed : {true, false}) {
            const FlowField field = make_flow_field(std::vector<Polyline>{circle(middle, 15)}, canvas,
                                                    {.step = 1, .directed = directed}, "strokes");
            // Without directions a full turn may come as two half turns side by side.
            int half_turns = 0;
            const auto points = singular_points(field);
            CHECK(points.size() <= (directed ? 1 : 2));
            for (const SingularPoint& point : points) {
                half_turns += point.half_turns;
                CHECK(abs(point.at - middle) < 4);
            }
            CHECK(half_turns == 2);
            CHECK(angle_between_lines(direction_at(field, middle + Point{15, 0}), {0, 1}) < 1);
            CHECK(angle_between_lines(direction_at(field, middle + Point{15, 15}), {-1, 1}) < 3);
        }
    }
}

TEST_CASE("strokes in opposite directions are one even flow if their direction does not count, and a wall if it does") {
    const std::vector<Polyline> strokes{{{10, 20}, {90, 20}}, {{90, 80}, {10, 80}}};
    const FlowField lines = make_flow_field(strokes, canvas, {.step = 1, .directed = false}, "strokes");
    const FlowField arrows = make_flow_field(strokes, canvas, {.step = 1}, "strokes");
    for (double y = 0; y <= 100; y += 2.5) {
        CHECK(angle_between(direction_at(lines, {47, y}), {1, 0}) < 0.01);
        CHECK(abs(direction_at(arrows, {47, y})) == Approx(1));  // also on the wall itself
        if (y != 50) CHECK(angle_between(direction_at(arrows, {47, y}), {y < 50 ? 1.0 : -1.0, 0}) < 0.01);
    }
    CHECK(singular_points(lines).empty());
    CHECK(singular_points(arrows).empty());
}

TEST_CASE("strokes that cancel each other still give a direction") {
    const std::vector<Polyline> strokes{{{10, 50}, {90, 50}}, {{90, 50}, {10, 50}}};
    const FlowField field = make_flow_field(strokes, canvas, {.step = 10}, "strokes");
    CHECK(abs(direction_at(field, {50, 50})) == Approx(1));
}

TEST_CASE("the table keeps within its cells, and very many strokes within the samples") {
    std::vector<Polyline> strokes;
    for (int i = 0; i < 700; ++i) strokes.push_back({{0.1 * i, 3}, {0.1 * i + 1, 3.5}});
    const FlowField field = make_flow_field(strokes, canvas, {.step = 1e-6, .max_cells = 1000}, "strokes");
    CHECK(field.columns * field.rows <= 1000);
    CHECK(angle_between(direction_at(field, {50, 50}), {1, 0.5}) < 1e-3);
}

TEST_CASE("strokes without a length are refused") {
    CHECK_THROWS_WITH(make_flow_field(std::vector<Polyline>{}, canvas, {}, "s.svg"),
                      Catch::Contains("s.svg: expected strokes that show the flow"));
}

}  // namespace rinceau
