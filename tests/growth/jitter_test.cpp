// Random differences between placed figures.

#include <catch2/catch.hpp>

#include "growth/arrangement/jitter.h"
#include "growth/arrangement/place_figures.h"
#include "growth/shared_area.h"

namespace rinceau {
namespace {

std::vector<Point> square(double half) { return {{-half, -half}, {half, -half}, {half, half}, {-half, half}}; }

/// One figure of two parts, red and grey, 10 by 10, on a grid of places.
FiguredDrawing drawing() {
    FiguredDrawing result;
    NumberedStyle red{.number = 1}, grey{.number = 2};
    red.style.fill = Color{200, 40, 40};
    grey.style.fill = Color{128, 128, 128};
    result.grammar.styles = {red, grey};
    result.grammar.terminals = {{.symbol = "A", .style = 1}, {.symbol = "B", .style = 2}};
    result.figures = {{.symbol = "A+B", .parts = {{.terminal = 0}, {.terminal = 1}}, .outline = {square(5)}, .radius = 7.1}};
    return result;
}

std::vector<PlacedFigure> grid(double spacing) {
    std::vector<PlacedFigure> placed;
    for (int row = 0; row < 8; ++row) {
        for (int column = 0; column < 8; ++column) placed.push_back({0, translate({column * spacing, row * spacing}), {}});
    }
    return placed;
}

double turn_of(const PlacedFigure& placed) { return arg(placed.pose.linear); }

}  // namespace

TEST_CASE("every element turns, grows and changes its colour within the ranges, about its centre") {
    const auto before = grid(40);
    const auto after = jittered(drawing(), before, {.angle = radians(30), .scale = 0.5, .color = 0.3});
    double most_turn = 0, most_scale = 0, least_scale = 9;
    for (std::size_t i = 0; i < after.size(); ++i) {
        CHECK(after[i].pose.translation == before[i].pose.translation);
        most_turn = std::max(most_turn, std::abs(turn_of(after[i])));
        most_scale = std::max(most_scale, scale_of(after[i].pose));
        least_scale = std::min(least_scale, scale_of(after[i].pose));
        REQUIRE(after[i].repaints.size() == 2);
        const Color red = *after[i].repaints[0].fill, grey = *after[i].repaints[1].fill;
        CHECK(red.red > red.blue);                   // a seventh of the hues to either side
        CHECK(std::abs(grey.red - grey.blue) <= 2);  // grey has no hue
    }
    CHECK(most_turn > radians(25));
    CHECK(most_turn <= radians(30));
    CHECK(most_scale > 1.4);
    CHECK(most_scale <= 1.5);
    CHECK(least_scale < 0.72);
    CHECK(least_scale >= 1 / 1.5);
}

TEST_CASE("one kind of jitter does not change what another one draws") {
    const auto before = grid(40);
    const auto all = jittered(drawing(), before, {.angle = 1, .scale = 0.5, .color = 0.3});
    const auto turned = jittered(drawing(), before, {.angle = 1});
    const auto grown = jittered(drawing(), before, {.scale = 0.5});
    const auto colored = jittered(drawing(), before, {.color = 0.3});
    for (std::size_t i = 0; i < all.size(); ++i) {
        CHECK(turn_of(turned[i]) == Approx(turn_of(all[i])));
        CHECK(scale_of(grown[i].pose) == Approx(scale_of(all[i].pose)));
        CHECK(colored[i].repaints == all[i].repaints);
        CHECK(colored[i].pose == before[i].pose);
    }
}

TEST_CASE("no two figures share area that did not before, nor does one cross a line") {
    const FiguredDrawing figures = drawing();
    const auto before = grid(11);
    const Boundary wall({{{-5.2, -20}, {-5.2, 100}}});
    const auto after = jittered(figures, before, {.angle = 1, .scale = 0.5}, &wall);
    int changed = 0;
    for (std::size_t i = 0; i < after.size(); ++i) {
        changed += after[i].pose == before[i].pose ? 0 : 1;
        CHECK_FALSE(wall.cuts(figures.figures[0].outline, after[i].pose));
        for (std::size_t k = 0; k < i; ++k)
            CHECK_FALSE(share_area(placed_outline(figures, after[i]), placed_outline(figures, after[k])));
    }
    CHECK(changed > 50);
}

TEST_CASE("what overlaps already may go on to, and another seed draws other numbers") {
    const auto before = grid(9);
    const auto first = jittered(drawing(), before, {.angle = 0.5});
    const auto again = jittered(drawing(), before, {.angle = 0.5});
    const auto other = jittered(drawing(), before, {.angle = 0.5, .seed = 2});
    int same = 0;
    for (std::size_t i = 0; i < first.size(); ++i) {
        CHECK(first[i].pose == again[i].pose);
        same += first[i].pose == other[i].pose ? 1 : 0;
    }
    CHECK(same < 3);
}

}  // namespace rinceau
