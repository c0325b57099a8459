#include <catch2/catch.hpp>

#include "geometry/angle.h"
#include "geometry/random.h"
#include "scene/element.h"

using namespace rinceau;

static Paint gradient(GradientKind kind, const Affine& map, Point focus = {}) {
    Gradient g;
    g.kind = kind;
    g.stops = {{0, {255, 0, 0}, 1}, {1, {0, 0, 255}, 0.5}};
    g.map = map;
    g.focus = focus;
    return std::make_shared<const Gradient>(g);
}

static Style rich_style() {
    Style style;
    style.fill = gradient(GradientKind::linear, {3, 1, -1, 3, 2, 5});
    style.stroke.paint = gradient(GradientKind::radial, {2, 0, 0, 4, 1, 1}, {0.3, 0.1});
    style.stroke.width = 2;
    style.stroke.dashes = {3, 1};
    style.stroke.pen = {2, 0, 0.5, 1};
    return style;
}

TEST_CASE("a style carried there and back is the same, carried along it is another") {
    Random random(11);
    for (int i = 0; i < 50; ++i) {
        const Similarity g{polar(random.uniform(0.5, 2), random.uniform(-pi, pi)), {random.uniform(-9, 9), 3}, i % 2 == 1};
        const Style there = transformed(rich_style(), g);
        CHECK(same_style(transformed(there, inverse(g)), rich_style(), 1e-9));
        CHECK_FALSE(same_style(there, rich_style(), 1e-3));
        CHECK(there.stroke.dashes[0] == Approx(3 * scale_of(g)));
    }
}

TEST_CASE("a fixed stroke keeps its width and dashes under a similarity, its paint follows") {
    Style style = rich_style();
    style.stroke.pen = {};
    style.stroke.fixed = true;
    const Similarity g{polar(3, 0.4), {1, 2}, true};
    const Style image = transformed(style, g);
    CHECK(image.stroke.width == 2);
    CHECK(image.stroke.dashes == style.stroke.dashes);
    Style painted = style;
    painted.stroke.fixed = false;
    painted = transformed(painted, g);
    CHECK_FALSE(same_style(image, painted, 1e-3));
    painted.stroke.width = 2;
    painted.stroke.dashes = style.stroke.dashes;
    CHECK(same_style(image, painted, 1e-9));  // in this frame the two paint the same
}

TEST_CASE("gradients that draw the same are the same, however they are written") {
    Style a, b;
    a.fill = gradient(GradientKind::linear, {1, 0, 0, 1, 0, 0});
    b.fill = gradient(GradientKind::linear, {1, 0, 0, 7, 0, 40});  // moved and stretched along the lines of equal colour
    CHECK(same_style(a, b, 1e-9));
    b.fill = gradient(GradientKind::linear, {1, 0, 0.5, 1, 0, 0});  // sheared: those lines have turned
    CHECK_FALSE(same_style(a, b, 1e-3));
    a.fill = gradient(GradientKind::radial, {2, 0, 0, 2, 5, 5});
    b.fill = gradient(GradientKind::radial, {0, -2, 2, 0, 5, 5});  // turned about its centre
    CHECK(same_style(a, b, 1e-9));
    b.fill = gradient(GradientKind::radial, {0, -2, 2, 0, 5, 5}, {0.5, 0});
    CHECK_FALSE(same_style(a, b, 1e-3));
}

TEST_CASE("only what is painted counts in comparing styles") {
    Style a, b;
    b.stroke.width = 9;
    b.stroke.dashes = {1, 2};
    CHECK(same_style(a, b, 1e-9));
    b.stroke.paint = Color{1, 2, 3};
    CHECK_FALSE(same_style(a, b, 1e-9));
    a.opacity = 0.5;
    b = Style{};
    b.fill_opacity = 0.5;
    CHECK(same_style(a, b, 1e-9));
    a.stroke.paint = b.stroke.paint = Color{};
    CHECK_FALSE(same_style(a, b, 1e-9));
    b = a;
    b.stroke.pen = {0, 1, -1, 0};  // a turned circle is a circle
    CHECK(same_style(a, b, 1e-9));
    b.stroke.pen = {1.1, 0, 0, 1};
    CHECK_FALSE(same_style(a, b, 1e-3));
}

TEST_CASE("the painted box holds the stroke, with mitres only where there are corners") {
    Element element;
    element.paths = {{{0, 0}, {line_to({10, 0})}, false}};
    element.style.stroke.paint = Color{};
    element.style.stroke.width = 2;
    CHECK(painted_box(element).high.y == 1);
    element.style.stroke.pen = {1, 0, 0, 3};
    CHECK(painted_box(element).high.y == 3);
    element.style.stroke.pen = {};
    element.paths[0].segments.push_back(line_to({0, 1}));
    const double mitre = 1 / std::sin(0.5 * std::atan2(1.0, 10.0));
    element.style.stroke.miter_limit = mitre;
    CHECK(painted_box(element).high.x >= 10 + mitre);
    element.style.stroke.paint = NoPaint{};
    CHECK(painted_box(element) == Box{{0, 0}, {10, 1}});
}

TEST_CASE("a style carried there and back is the same also where its lengths are far beyond the tolerance") {
    Style style = rich_style();
    style.stroke.width = 1e12;
    style.stroke.dashes = {1e99, 6};
    const Similarity g{polar(1.3, 0.7), {5, 3}, false};
    CHECK(same_style(transformed(transformed(style, g), inverse(g)), style, 1e-3));
    CHECK_FALSE(same_style(transformed(style, Similarity{polar(1 + 1e-9, 0), {}, false}), style, 1e-3));
}
