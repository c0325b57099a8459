#include "exports/plain_color.h"

#include <catch2/catch.hpp>

using namespace rinceau;

static Paint gradient(std::vector<GradientStop> stops) {
    return std::make_shared<const Gradient>(Gradient{.stops = std::move(stops)});
}

TEST_CASE("a gradient's plain colour is the mean along its axis") {
    const auto even = plain_color(gradient({{0, {0, 0, 0}}, {1, {200, 100, 50}}}));
    REQUIRE(even);
    CHECK(even->color == Color{100, 50, 25});
    CHECK(even->opacity == 1);
    // before the first stop and behind the last one the colours go on
    const auto late = plain_color(gradient({{0.5, {0, 0, 0}}, {0.5, {200, 0, 0}}}));
    CHECK(late->color == Color{100, 0, 0});
}

TEST_CASE("what is transparent does not colour the mean") {
    const auto half = plain_color(gradient({{0, {255, 0, 0}, 0}, {1, {0, 0, 255}, 1}}));
    CHECK(half->color == Color{0, 0, 255});
    CHECK(half->opacity == Approx(0.5));
    const auto nothing = plain_color(gradient({{0, {255, 0, 0}, 0}, {1, {0, 0, 255}, 0}}));
    CHECK(nothing->opacity == 0);
}

TEST_CASE("no paint has no colour, a colour is itself") {
    CHECK_FALSE(plain_color(NoPaint{}));
    CHECK(hex_text(plain_color(Color{1, 171, 255})->color) == "#01abff");
}
