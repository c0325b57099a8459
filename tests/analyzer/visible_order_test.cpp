#include <catch2/catch.hpp>

#include "analyzer/visible_order.h"
#include "closed_loop/shapes.h"
#include "geometry/random.h"

using namespace rinceau;
using namespace rinceau::test;

namespace {

constexpr Color red{255, 0, 0};
constexpr Color green{0, 128, 0};
constexpr Color black{0, 0, 0};

Style outlined(Color fill, Color stroke, double width) {
    Style style = filled(fill);
    style.stroke.paint = stroke;
    style.stroke.width = width;
    return style;
}

Element tile(double left, double low, double side, const Style& style) {
    return placed(element(rectangle(side, side), style), translate({left + side / 2, low + side / 2}));
}

Element dot(Point at, double diameter, Color color) { return placed(element(circle(diameter / 2), filled(color)), translate(at)); }

Style gradient_from(Color first, Color second, double length) {
    Style style;
    style.fill = std::make_shared<const Gradient>(
        Gradient{.stops = {{0, first, 1}, {1, second, 1}}, .map = {length, 0, 0, length, 0, 0}});
    return style;
}

/// One unit of length is a pixel; whichever is first does not matter.
bool seen(const Element& a, const Element& b) {
    const bool visible = order_can_be_seen(a, b, 1);
    CHECK(order_can_be_seen(b, a, 1) == visible);
    return visible;
}

}  // namespace

TEST_CASE("tiles that only touch hide their order unless strokes of two colours meet") {
    for (const double angle : {0.0, 0.3, 1.1}) {
        const Similarity turned{polar(1, angle), {0.37, 0.21}, false};
        const auto neighbours_seen = [&](const Style& left, const Style& right) {
            return seen(placed(tile(0, 0, 30, left), turned), placed(tile(30, 0, 30, right), turned));
        };
        CHECK_FALSE(neighbours_seen(filled(red), filled(green)));
        for (const double width : {0.2, 1.0, 3.0}) CHECK_FALSE(neighbours_seen(outlined(red, black, width), outlined(green, black, width)));
        CHECK(neighbours_seen(outlined(red, black, 2), outlined(red, green, 2)));
        CHECK(neighbours_seen(outlined(red, black, 4), filled(green)));
    }
}

TEST_CASE("overlapping by less than half a pixel hides the order, by a pixel and a half shows it") {
    for (const double angle : {0.0, 0.4, 0.785}) {
        const Similarity turned{polar(1, angle), {0.1, 0.2}, false};
        for (const double overlap : {0.05, 0.3, 0.5, 1.5, 2.0, 8.0}) {
            const bool visible = seen(placed(tile(0, 0, 30, filled(red)), turned), placed(tile(30 - overlap, 0, 30, filled(green)), turned));
            CHECK(visible == (overlap > 1));
        }
    }
}

TEST_CASE("a hair or a dot on a ground is seen as far as it darkens a pixel") {
    const Element ground = tile(0, 0, 60, filled({255, 255, 255}));
    for (const double width : {0.02, 0.12, 0.3, 0.6, 2.0}) {
        const Element hair = element({Path{.start = {5, 7}, .segments = {line_to({50, 41})}}}, stroked(black, width));
        CHECK(seen(ground, hair) == (width > 0.1));
    }
    for (const double diameter : {0.1, 0.2, 1.2, 3.0}) CHECK(seen(ground, dot({20.3, 30.1}, diameter, black)) == (diameter > 1));
    CHECK_FALSE(seen(ground, dot({20, 30}, 10, {250, 250, 250})));
    CHECK_FALSE(seen(ground, dot({100, 30}, 10, black)));
}

TEST_CASE("what has one colour in both orders hides them: equal fills, strokes crossing") {
    CHECK_FALSE(seen(tile(0, 0, 30, filled(red)), tile(10, 10, 30, filled(red))));
    CHECK(seen(tile(0, 0, 30, outlined(red, black, 2)), tile(10, 10, 30, outlined(red, green, 2))));
    CHECK(seen(tile(0, 0, 30, outlined(red, black, 2)), tile(10, 10, 30, outlined(red, black, 2))));
    const auto line = [](Point from, Point to, Color color) {
        return element({Path{.start = from, .segments = {line_to(to)}}}, stroked(color, 2));
    };
    CHECK_FALSE(seen(line({0, 0}, {30, 30}, black), line({30, 0}, {0, 30}, black)));
    CHECK(seen(line({0, 0}, {30, 30}, black), line({30, 0}, {0, 30}, red)));
}

TEST_CASE("the fainter two things are, the less their order shows") {
    const auto faint = [](Color color, double opacity) {
        Style style = filled(color);
        style.fill_opacity = opacity;
        return style;
    };
    CHECK(seen(tile(0, 0, 30, faint(red, 0.5)), tile(10, 10, 30, faint(green, 0.5))));
    CHECK_FALSE(seen(tile(0, 0, 30, faint(red, 0.2)), tile(10, 10, 30, faint(green, 0.2))));  // 0.04 of 255 is less than 16
    CHECK_FALSE(seen(tile(0, 0, 30, faint(red, 0.5)), tile(10, 10, 30, faint(red, 0.5))));
    Style whole = filled(red);
    whole.opacity = 0.05;
    CHECK_FALSE(seen(tile(0, 0, 30, whole), tile(10, 10, 30, filled(green))));
}

TEST_CASE("gradients count by their colour where the two overlap") {
    const Style fade = gradient_from(red, green, 60);
    // The gradients stay where they are, whatever they are painted into.
    const auto unmoved = [](double left, double low, double side, const Style& style) {
        Element painted = tile(left, low, side, filled(black));
        painted.style = style;
        return painted;
    };
    const Element ground = unmoved(0, 0, 60, fade);
    CHECK_FALSE(seen(ground, tile(1, 20, 4, filled({247, 5, 0}))));
    CHECK(seen(ground, tile(50, 20, 4, filled({247, 5, 0}))));
    CHECK_FALSE(seen(ground, unmoved(10, 10, 30, fade)));
    Style round = fade;
    Gradient radial = *std::get<std::shared_ptr<const Gradient>>(fade.fill);
    radial.kind = GradientKind::radial;
    radial.map = {30, 0, 0, 30, 30, 30};
    round.fill = std::make_shared<const Gradient>(radial);
    CHECK_FALSE(seen(unmoved(0, 0, 60, round), tile(0, 0, 6, filled(green))));
    CHECK(seen(unmoved(0, 0, 60, round), tile(28, 28, 6, filled(green))));
}

TEST_CASE("what stands in an even-odd hole has no order, nor what dashes and fill leave alone") {
    Element ring = placed(element(frame(4, 0.8), filled(red)), Similarity{{40, 0}, {50, 50}, false});
    ring.style.fill_rule = FillRule::evenodd;
    CHECK_FALSE(seen(ring, dot({50, 50}, 10, green)));
    CHECK(seen(ring, dot({50, 87}, 5, green)));
    Style dashed = outlined(red, black, 4);
    dashed.stroke.dashes = {3, 3};
    Style other = dashed;
    other.fill = green;
    CHECK(seen(tile(0, 0, 30, dashed), tile(0, 0, 30, other)));
    CHECK(seen(tile(0, 0, 30, dashed), tile(15, 0, 30, other)));
}

TEST_CASE("long outlines side by side end in a bounded number of points, as visible") {
    std::vector<Element> rings;
    for (const Color color : {red, green}) {
        rings.push_back(placed(element(circle(1), stroked(color, 1e-6)), Similarity{{400, 0}, {400, 400}, false}));
    }
    CHECK(order_can_be_seen(rings[0], rings[1], 1e-3, {.max_samples = 1000}));
}

TEST_CASE("the order of two discs is seen exactly if the lens that they share is thick") {
    Random random(5);
    int visible = 0;
    for (int k = 0; k < 400; ++k) {
        const double r = random.uniform(2, 30);
        const double s = random.uniform(2, 30);
        const double gap = random.uniform(-4, 1);
        const Point p{random.uniform(0, 1), random.uniform(0, 1)};
        const Point q = p + polar(r + s + gap, random.uniform(0, 6.28));
        const bool found = seen(dot(p, 2 * r, black), dot(q, 2 * s, red));
        visible += found;
        if (gap < -2.5) CHECK(found);
        if (gap > -0.3) CHECK_FALSE(found);
    }
    CHECK(visible > 50);
}
