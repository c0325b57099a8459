#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <string>

#include "geometry/angle.h"
#include "scene/svg_path_data.h"

using namespace rinceau;

static std::vector<Path> paths_of(std::string_view text) {
    const ParsedPath parsed = parse_path_data(text);
    INFO(text << ": " << parsed.fault);
    CHECK_FALSE(parsed.faulty);
    return parsed.paths;
}

static double distance_between(const std::vector<Path>& a, const std::vector<Path>& b) {
    REQUIRE(a.size() == b.size());
    double worst = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        REQUIRE(a[i].segments.size() == b[i].segments.size());
        CHECK(a[i].closed == b[i].closed);
        worst = std::max(worst, abs(a[i].start - b[i].start));
        for (std::size_t k = 0; k < a[i].segments.size(); ++k) {
            const Segment& s = a[i].segments[k];
            const Segment& t = b[i].segments[k];
            CHECK(s.straight == t.straight);
            worst = std::max({worst, abs(s.to - t.to), abs(s.control1 - t.control1), abs(s.control2 - t.control2)});
        }
    }
    return worst;
}

TEST_CASE("every relative command draws what its absolute form draws") {
    const std::pair<const char*, const char*> pairs[] = {
        {"M10 20L30 40H50V60", "m10 20l20 20h20v20"},
        {"M10 20 30 40 50 60", "m10 20 20 20 20 20"},
        {"M1 2C3 4 5 6 7 8S9 10 11 12", "m1 2c2 2 4 4 6 6s2 2 4 4"},
        {"M1 2Q3 9 7 8T11 12", "m1 2q2 7 6 6t4 4"},
        {"M10 10A5 7 30 0 1 18 12A5 7 30 1 0 20 20", "m10 10a5 7 30 0 1 8 2a5 7 30 1 0 2 8"},
        {"M0 0H5V5ZM10 10H5Z", "m0 0h5v5zm10 10h-5z"},
        {"M5 5H9ZL7 7", "m5 5h4zl2 2"},
    };
    for (const auto& [absolute, relative] : pairs) {
        CAPTURE(absolute);
        CHECK(distance_between(paths_of(absolute), paths_of(relative)) < 1e-12);
    }
}

TEST_CASE("smooth curves mirror the control point before only after a curve of their kind") {
    CHECK(distance_between(paths_of("M0 0C1 2 3 4 5 5S8 8 9 9"), paths_of("M0 0C1 2 3 4 5 5C7 6 8 8 9 9")) < 1e-12);
    CHECK(distance_between(paths_of("M0 0L5 5S8 8 9 9"), paths_of("M0 0L5 5C5 5 8 8 9 9")) < 1e-12);
    CHECK(distance_between(paths_of("M0 0Q1 2 5 5S8 8 9 9"), paths_of("M0 0Q1 2 5 5C5 5 8 8 9 9")) < 1e-12);
    CHECK(distance_between(paths_of("M0 0Q4 0 4 4T8 8"), paths_of("M0 0Q4 0 4 4Q4 8 8 8")) < 1e-12);
    CHECK(distance_between(paths_of("M0 0L4 4T8 8"), paths_of("M0 0L4 4Q4 4 8 8")) < 1e-12);
}

TEST_CASE("numbers need separators only where they would run together") {
    const std::vector<Path> path = paths_of("M.5.5L10.5.5-1-2+3e1,4E-1\n1.5e+1\t2.");
    REQUIRE(path.size() == 1);
    CHECK(path[0].start == Point{0.5, 0.5});
    REQUIRE(path[0].segments.size() == 4);
    CHECK(path[0].segments[1].to == Point{-1, -2});
    CHECK(path[0].segments[2].to == Point{30, 0.4});
    CHECK(path[0].segments[3].to == Point{15, 2});
}

TEST_CASE("the flags of an arc may be glued to each other and to the next number") {
    CHECK(distance_between(paths_of("M100 50a20,20 0 0 1 40,0"), paths_of("M100 50a20,20 0 0140,0")) == 0);
    CHECK(distance_between(paths_of("M100 50a20,20 0 1 0 .5,4"), paths_of("M100 50a20 20 0 10.5 4")) == 0);
}

TEST_CASE("two half circles have the points, the box and the length of the circle") {
    const std::vector<Path> circle = paths_of("M20 50A30 30 0 0 1 80 50A30 30 0 0 1 20 50Z");
    REQUIRE(circle.size() == 1);
    CHECK(circle[0].segments.size() == 4);
    CHECK(length(circle) == Approx(60 * pi).epsilon(3e-4));
    const Box box = bounds(circle);
    CHECK(abs(box.low - Point{20, 20}) < 1e-9);
    CHECK(abs(box.high - Point{80, 80}) < 1e-9);
    for (const Point p : flattened(circle[0], 0.01)) CHECK(abs(p - Point{50, 50}) == Approx(30).epsilon(3e-4));
}

TEST_CASE("an arc whose chord is nothing beside its radii, or its radii beside the chord, is a line") {
    for (const char* data : {"M0 0A5 5 0 1 1 1e-200 0", "M0 0a1e-200 1e-200 30 0 1 7 4"}) {
        const ParsedPath parsed = parse_path_data(data);
        CHECK_FALSE(parsed.faulty);
        REQUIRE(parsed.paths.size() == 1);
        REQUIRE(parsed.paths[0].segments.size() == 1);
        CHECK(parsed.paths[0].segments[0] == line_to(parsed.paths[0].segments[0].to));
    }
}

TEST_CASE("an arc keeps to its turned ellipse, on the side that its flags say") {
    const double turn = radians(30);
    for (const int large : {0, 1}) {
        for (const int sweep : {0, 1}) {
            const Point from{10, 0}, to{16, 5};
            const std::vector<Path> arc =
                paths_of("M10 0A9 4 30 " + std::to_string(large) + " " + std::to_string(sweep) + " 16 5");
            // Two points of the arc and the radii give the centre; all other points must lie on the same ellipse.
            const auto unit = [&](Point p) {
                const Point q = conj(polar(1, turn)) * p;
                return Point{q.x / 9, q.y / 4};
            };
            const Point a = unit(from), b = unit(to), middle = 0.5 * (a + b);
            const double away = std::sqrt(1 - norm(0.5 * (b - a)));
            const Point side = Point{-(b - a).y, (b - a).x} / abs(b - a);
            const Point center = middle + (large != sweep ? away : -away) * side;
            double swept = 0;
            Point before = a - center;
            for (const Point p : flattened(arc[0], 1e-4)) {
                const Point now = unit(p) - center;
                CHECK(abs(now) == Approx(1).epsilon(4e-4));
                swept += std::atan2(cross(before, now), dot(before, now));
                before = now;
            }
            CHECK((swept > 0) == (sweep == 1));
            CHECK((std::abs(swept) > pi) == (large == 1));
        }
    }
}

TEST_CASE("radii that are too small grow, a radius of zero draws a line") {
    CHECK(distance_between(paths_of("M150 50A1 1 0 0 1 190 50"), paths_of("M150 50A20 20 0 0 1 190 50")) < 1e-9);
    CHECK(distance_between(paths_of("M10 100A0 5 0 0 1 60 100"), paths_of("M10 100L60 100")) == 0);
    CHECK(distance_between(paths_of("M1 1A-5 -5 0 0 1 6 6"), paths_of("M1 1A5 5 0 0 1 6 6")) == 0);
}

TEST_CASE("sub-paths without a drawing command are left out, dots are kept") {
    CHECK(paths_of("").empty());
    CHECK(paths_of("M1 1").empty());
    CHECK(paths_of("M1 1M2 2L3 3M4 4").size() == 1);
    for (const char* dot : {"M1 1h0", "M1 1l0 0", "M1 1L1 1", "M1 1V1"}) {
        const std::vector<Path> paths = paths_of(dot);
        REQUIRE(paths.size() == 1);
        CHECK(paths[0] == Path{{1, 1}, {line_to({1, 1})}, false});
    }
    CHECK(paths_of("M1 1z") == std::vector<Path>{{{1, 1}, {}, true}});
}

TEST_CASE("after closing, drawing goes on from the start of the closed sub-path") {
    const std::vector<Path> paths = paths_of("M5 5h4v4zl-2 -2z m1 0 h1");
    REQUIRE(paths.size() == 3);
    CHECK(paths[1].start == Point{5, 5});
    CHECK(paths[1].segments[0].to == Point{3, 3});
    CHECK(paths[2].start == Point{6, 5});
}

TEST_CASE("everything before a fault is kept and the fault is located") {
    struct Case {
        const char* text;
        std::size_t fault_at;
        std::size_t segments;
    };
    const Case cases[] = {
        {"M10 10L20 10 20 20 X 30 30", 19, 2},
        {"M30 10h10v10z garbage", 14, 2},
        {"L100 100 200 100z", 0, 0},
        {"M0 0L1 1,,2 2", 8, 1},
        {"M0 0L1 1 2", 10, 1},
        {"M0 0L1 1,", 8, 1},
        {"M0 0L1 1a5 5 0 2 0 1 1", 15, 1},
        {"M0 0L1 1L1e16 0", 9, 1},
        {"M0 0L1 1L1e400 0", 9, 1},
        {"M0 0L1 1LNaN 0", 9, 1},
        {"M0 0L1 1L#", 9, 1},
        {"10 10", 0, 0},
        {"M0 0L1 1C1 1 2 2", 16, 1},
        {"M0 0L1 1e", 8, 1},
        {"M0 0l9e14 0l2e14 0", 12, 1},
    };
    for (const Case& c : cases) {
        CAPTURE(c.text);
        const ParsedPath parsed = parse_path_data(c.text);
        CHECK(parsed.faulty);
        CHECK(parsed.fault_at == c.fault_at);
        CHECK_FALSE(parsed.fault.empty());
        CHECK((parsed.paths.empty() ? 0 : parsed.paths[0].segments.size()) == c.segments);
    }
}

TEST_CASE("a curve whose implied points lie beyond the largest coordinate is a fault, and draws nothing") {
    const std::string begin = "M22 20L30 20";
    for (const char* beyond : {"A5 1e15 0 1 0 22 20", "C1 1 -9e14 -9e14 9e14 9e14S1 1 2 2", "T9e14 0T-9e14 0T9e14 0"}) {
        const ParsedPath parsed = parse_path_data(begin + beyond);
        INFO(beyond << ": " << parsed.fault);
        CHECK(parsed.faulty);
        REQUIRE_FALSE(parsed.paths.empty());
        CHECK(parsed.paths.front().start == Point{22, 20});
        for (const Segment& segment : parsed.paths.front().segments)
            for (const Point p : {segment.control1, segment.control2, segment.to})
                CHECK(std::max(std::abs(p.x), std::abs(p.y)) <= largest_coordinate);
        for (const auto& [path, joint] : parsed.arc_joints) CHECK(joint < parsed.paths[path].segments.size());
    }
}
