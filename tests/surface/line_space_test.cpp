#include "growth/surface/line_space.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "geometry/polygon.h"
#include "geometry/random.h"

namespace rinceau {

TEST_CASE("a piece is cut at the first line that it crosses") {
    LineSpace lines;
    lines.add({0.7, -1, 0}, {0.7, 1, 0}, 0.1, 0);
    lines.add({0.3, -1, 0.01}, {0.3, 1, 0.01}, 0.1, 1);
    const auto met = lines.first_meeting({0, 0, 0}, {1, 0, 0}, 0.1, 2, 0);
    REQUIRE(met);
    CHECK(met->line == 1);
    CHECK(met->share == Approx(0.3));
    CHECK(met->point.x == Approx(0.3));
    CHECK(met->point.z == Approx(0.01));
    CHECK_FALSE(lines.first_meeting({0, 2, 0}, {1, 2, 0}, 0.1, 2, 0));
    CHECK_FALSE(lines.first_meeting({0, 0, 0}, {0.29, 0, 0}, 0.1, 2, 0));  // ends before
}

TEST_CASE("lines that pass each other farther off than their width do not meet") {
    LineSpace lines;
    lines.add({0.5, -1, 0}, {0.5, 1, 0}, 0.1, 0);
    CHECK(lines.first_meeting({0, 0, 0.11}, {1, 0, 0.11}, 0.1, 1, 0));
    CHECK_FALSE(lines.first_meeting({0, 0, 0.13}, {1, 0, 0.13}, 0.1, 1, 0));
}

TEST_CASE("a line does not meet the pieces that it has just come from, but its own early ones") {
    LineSpace lines;
    lines.add({0, 0, 0}, {1, 0, 0}, 0.1, 0);
    lines.add({1, 0, 0}, {1, 1, 0}, 0.1, 0);
    lines.add({1, 1, 0}, {0.5, 1, 0}, 0.1, 0);
    CHECK_FALSE(lines.first_meeting({0.5, 1, 0}, {0.5, 0.5, 0}, 0.1, 0, 2));
    const auto met = lines.first_meeting({0.5, 0.5, 0}, {0.5, -0.5, 0}, 0.1, 0, 2);
    REQUIRE(met);
    CHECK(met->share == Approx(0.5));
    CHECK_FALSE(lines.first_meeting({0.5, 0.5, 0}, {0.5, -0.5, 0}, 0.1, 0, 3));
}

TEST_CASE("a branch that begins on or beside its stem does not meet it, and the stem goes on past the branch") {
    LineSpace lines;
    lines.add({0, 0, 0}, {1, 0, 0}, 0.3, 0);
    CHECK_FALSE(lines.first_meeting({1, 0, 0}, {1.3, 0.9, 0}, 0.3, 1, 0));
    CHECK_FALSE(lines.first_meeting({1, 0.2, 0}, {1.3, 0.9, 0}, 0.3, 1, 0));
    lines.add({1, 0.2, 0}, {1.3, 0.9, 0}, 0.3, 1);
    CHECK_FALSE(lines.first_meeting({1, 0, 0}, {2, 0, 0}, 0.3, 0, 1));
}

TEST_CASE("lines that grow towards each other end where they come together") {
    LineSpace lines;
    lines.add({2, 0, 0}, {1, 0, 0}, 0.1, 0);
    const auto met = lines.first_meeting({0.5, 0.01, 0}, {1.5, 0.01, 0}, 0.1, 1, 0);
    REQUIRE(met);
    CHECK(met->share < 0.5);
    CHECK(met->share > 0.4);
    CHECK(met->point.x == Approx(1));
    // Side by side at more than their width they run on.
    CHECK_FALSE(lines.first_meeting({0.5, 0.12, 0}, {1.5, 0.12, 0}, 0.1, 1, 0));
}

TEST_CASE("the grid finds the meeting that all pairs give, for short and long pieces") {
    Random random(3);
    struct Flat {
        Point a, b;
    };
    LineSpace lines;
    std::vector<Flat> pieces;
    int meetings = 0;
    for (int i = 0; i < 400; ++i) {
        const Point a{random.uniform(-2, 2), random.uniform(-2, 2)};
        const double length = std::exp(random.uniform(-4, 0.5)), turn = random.uniform(0, 7);
        const Point b = a + polar(length, turn);
        double first = 2;
        for (const Flat& other : pieces)
            if (const auto crossing = segment_crossing(a, b, other.a, other.b)) first = std::min(first, crossing->along_a);
        const auto met = lines.first_meeting({a.x, a.y, 0}, {b.x, b.y, 0}, 1e-9, i, 0);
        // Nearly parallel pieces are no crossings for the space.
        if (met) CHECK(met->share == Approx(first).margin(1e-6));
        if (!met && first <= 1) {
            bool skew = false;
            for (const Flat& other : pieces)
                if (segment_crossing(a, b, other.a, other.b))
                    skew = skew || std::abs(cross(b - a, other.b - other.a)) > 0.11 * abs(b - a) * abs(other.b - other.a);
            CHECK_FALSE(skew);
        }
        meetings += met.has_value();
        lines.add({a.x, a.y, 0}, {b.x, b.y, 0}, 1e-9, i);
        pieces.push_back({a, b});
    }
    CHECK(meetings > 80);
}

}  // namespace rinceau
