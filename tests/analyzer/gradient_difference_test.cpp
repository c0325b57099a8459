// Gradients are equal where the same colours are seen, whatever they are elsewhere.
#include <catch2/catch.hpp>

#include "analyzer/gradient_difference.h"

using namespace rinceau;

namespace {

Gradient black_to_white(GradientKind kind, const Affine& map) {
    Gradient gradient;
    gradient.kind = kind;
    gradient.stops = {{0, {0, 0, 0}, 1}, {1, {255, 255, 255}, 1}};
    gradient.map = map;
    return gradient;
}

Affine turned_about(const Affine& map, Point at, double angle) {
    return to_affine(translate(at) * rotate(angle) * translate({-at.x, -at.y})) * map;
}

const Box box{{300, 300}, {320, 320}};
const Affine there{20, 0, 0, 20, 300, 310};

}  // namespace

TEST_CASE("a gradient turned by a thousandth about its element is the same, however far the origin is") {
    for (const GradientKind kind : {GradientKind::linear, GradientKind::radial}) {
        const Gradient a = black_to_white(kind, there);
        CHECK(same_gradient_in(a, black_to_white(kind, turned_about(there, center(box), 1e-3)), box, 0.02));
        CHECK_FALSE(same_gradient_in(a, black_to_white(kind, turned_about(there, {}, 0.02)), box, 0.02));
        CHECK_FALSE(same_gradient_in(a, black_to_white(kind, {30, 0, 0, 30, 300, 310}), box, 0.02));
    }
}

TEST_CASE("an edge between two colours must stand in its place, a slow change of colour need not") {
    Gradient soft = black_to_white(GradientKind::linear, {2000, 0, 0, 2000, 0, 0});
    Gradient moved = soft;
    moved.map.e += 5;
    CHECK(same_gradient_in(soft, moved, box, 0.02));
    soft.stops = {{0, {0, 0, 0}, 1}, {0.155, {0, 0, 0}, 1}, {0.155, {255, 0, 0}, 1}, {1, {255, 0, 0}, 1}};
    moved.stops = soft.stops;
    CHECK_FALSE(same_gradient_in(soft, moved, box, 0.02));
}

TEST_CASE("other stops, spreads and foci are other gradients") {
    const Gradient a = black_to_white(GradientKind::radial, there);
    Gradient b = a;
    b.stops[1].color = {255, 255, 250};
    CHECK_FALSE(same_gradient_in(a, b, box, 0.02));
    b = a;
    b.spread = GradientSpread::repeat;
    CHECK_FALSE(same_gradient_in(a, b, box, 0.02));
    b = a;
    b.focus = {0.3, 0};
    CHECK_FALSE(same_gradient_in(a, b, box, 0.02));
    CHECK(same_gradient_in(b, b, box, 0.02));
}
