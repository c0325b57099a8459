#include <catch2/catch.hpp>

#include "geometry/angle.h"
#include "scene/svg_color.h"
#include "scene/svg_number.h"
#include "scene/svg_transform.h"
#include "scene/svg_units.h"
#include "scene/svg_viewport.h"

using namespace rinceau;

TEST_CASE("numbers are written in the shortest form that reads back the same") {
    const std::pair<double, const char*> cases[] = {{0.1, "0.1"},    {-0.0, "0"},  {1.0 / 3, "0.3333333333333333"},
                                                    {1e21, "1e+21"}, {100, "100"}, {-2.5, "-2.5"},
                                                    {1e-9, "1e-09"}};
    for (const auto& [value, text] : cases) {
        CHECK(svg_number(value) == text);
        CHECK(parse_number(text) == value);
    }
    CHECK(svg_number(123.456789, 4) == "123.5");
    CHECK(svg_number(2.0000001, 4) == "2");
}

TEST_CASE("what is no number is refused, what is too small is zero") {
    for (const char* text : {"", "-", ".", "e5", "1e", "1 2", "nan", "inf", "0x10", "1e999", "--1", "1,"}) {
        CAPTURE(text);
        CHECK_FALSE(parse_number(text));
    }
    CHECK(parse_number(" +1.5e2 ") == 150.0);
    CHECK(parse_number("1e-999") == 0.0);
    CHECK(parse_number("5.") == 5.0);
    CHECK_FALSE(parse_numbers("1, 2,"));
    CHECK(parse_numbers("1,2 3-4").value() == std::vector<double>{1, 2, 3, -4});
}

TEST_CASE("every unit is what CSS says at 96 px an inch") {
    UnitContext context;
    context.width = 300;
    context.height = 400;
    context.font_size = 20;
    context.root_font_size = 10;
    context.page_width = 1000;
    context.page_height = 500;
    const std::pair<const char*, double> cases[] = {{"96", 96},  {"96px", 96},   {"1in", 96},    {"72pt", 96},
                                                    {"6pc", 96}, {"2.54cm", 96}, {"25.4mm", 96}, {"101.6Q", 96},
                                                    {"2em", 40}, {"2ex", 20},    {"3rem", 30},   {"10%", 30},
                                                    {"1vw", 10}, {"1vh", 5},     {"1E1PX", 10},  {" -3mm ", -3 * 96 / 25.4}};
    for (const auto& [text, px] : cases) {
        CAPTURE(text);
        CHECK(parse_length(text, context, LengthAxis::x).value() == Approx(px).epsilon(1e-14));
    }
    CHECK(parse_length("50%", context, LengthAxis::y) == 200.0);
    CHECK(parse_length("100%", context, LengthAxis::diagonal).value() == Approx(std::sqrt((9e4 + 16e4) / 2)));
    for (const char* faulty : {"auto", "3 px", "3foo", "px", "", "1e308in"})
        CHECK_FALSE(parse_length(faulty, context, LengthAxis::x));
    CHECK(parse_lengths("1, 2mm 10%", context, LengthAxis::x).value().size() == 3);
    CHECK_FALSE(parse_lengths("1, x", context, LengthAxis::x));
    CHECK(parse_font_size("larger", context) == Approx(24));
    CHECK(parse_font_size("50%", context) == Approx(10));
    CHECK(parse_font_size("medium", context) == Approx(16));
}

TEST_CASE("opacities are numbers or percentages between 0 and 1") {
    CHECK(parse_opacity("50%") == 0.5);
    CHECK(parse_opacity("-1") == 0.0);
    CHECK(parse_opacity("7") == 1.0);
    CHECK_FALSE(parse_opacity("half"));
}

TEST_CASE("all ways of writing a colour give the same colour") {
    const ParsedColor teal{{0, 128, 128}};
    for (const char* text :
         {"teal", "TEAL", "#008080", "#008080ff", "rgb(0,128,128)", "rgb( 0 128 128 )", "rgba(0, 128, 128, 1)",
          "rgb(0 128 128 / 100%)", "rgb(0%, 50.1%, 50.1%)", "hsl(180, 100%, 25.1%)", "hsl(0.5turn 100% 25.1%)",
          "hsl(-180deg 100% 25.1%)", " #008080 icc-color(x, 1) "}) {
        CAPTURE(text);
        CHECK(parse_color(text) == teal);
    }
    CHECK(parse_color("#f80") == ParsedColor{{255, 136, 0}});
    CHECK(parse_color("#f808") == ParsedColor{{255, 136, 0}, 136 / 255.0});
    CHECK(parse_color("rgba(300,-5,0,50%)") == ParsedColor{{255, 0, 0}, 0.5});
    CHECK(parse_color("transparent")->opacity == 0);
    CHECK(parse_color("currentColor")->current);
    CHECK(parse_color("yellowgreen") == ParsedColor{{154, 205, 50}});
    CHECK(parse_color("aliceblue") == ParsedColor{{240, 248, 255}});
    for (const char* text : {"", "#", "#12", "#ggg", "rgb(1,2)", "rgb(1,2,3", "rgb(1,2,3,)", "hsl(1,2,3)", "bleu", "none"}) {
        CAPTURE(text);
        CHECK_FALSE(parse_color(text));
    }
}

TEST_CASE("a paint is none, a colour, or a reference with or without fallback") {
    CHECK(parse_paint("none")->kind == PaintKind::none);
    CHECK(parse_paint("red")->color.color == Color{255, 0, 0});
    const ParsedPaint plain = parse_paint("url( '#a b' )").value();
    CHECK(plain.reference == "#a b");
    CHECK_FALSE(plain.has_fallback);
    const ParsedPaint fallback = parse_paint("url(#g) rgb(1,2,3)").value();
    CHECK(fallback.reference == "#g");
    CHECK(fallback.fallback_color.color == Color{1, 2, 3});
    CHECK(parse_paint("url(#g) none")->has_fallback);
    CHECK_FALSE(parse_paint("url(#g"));
}

static Point mapped(std::string_view transform, Point p) {
    return apply(parse_transform_attribute(transform).map.value(), p);
}

TEST_CASE("a list of transforms applies the last one first") {
    CHECK(abs(mapped("translate(10,20) scale(2)", {1, 1}) - Point{12, 22}) < 1e-14);
    CHECK(abs(mapped("scale(2),translate(10)", {1, 1}) - Point{22, 2}) < 1e-14);
    CHECK(abs(mapped("rotate(90)", {1, 0}) - Point{0, 1}) == 0);
    CHECK(abs(mapped("rotate(180 5 5)", {0, 0}) - Point{10, 10}) == 0);
    CHECK(abs(mapped("skewX(45)skewY(0)", {0, 1}) - Point{1, 1}) < 1e-14);
    CHECK(mapped(" matrix(1-2 3.5.5,5 6)", {1, 1}) == Point{9.5, 4.5});
    CHECK(mapped("", {3, 4}) == Point{3, 4});
}

TEST_CASE("faulty transforms are refused with a reason") {
    for (const char* text :
         {"rotate(1,2)", "translate()", "translate(1,)", "scale(1 2 3)", "foo(1)", "matrix(1 2 3)", "translate(1px)",
          "rotate(45deg)", "translate(1", "12", "scale(1e400)", "rotate(1e308)", "translate(1),"}) {
        CAPTURE(text);
        const ParsedTransform parsed = parse_transform_attribute(text);
        CHECK_FALSE(parsed.map);
        CHECK_FALSE(parsed.fault.empty());
    }
}

TEST_CASE("transforms of style sheets have units and percentages of the reference box") {
    const Box box{{10, 20}, {110, 220}};
    const UnitContext units;
    const auto at = [&](std::string_view text, Point p) {
        return apply(parse_css_transform(text, units, box).map.value(), p);
    };
    CHECK(at("translate(50%, 1in)", {0, 0}) == Point{50, 96});
    CHECK(at("translateX(5px) translateY(10%)", {0, 0}) == Point{5, 20});
    for (const char* quarter : {"rotate(90deg)", "rotate(0.25turn)", "rotate(100grad)", "rotate(1.5707963267948966rad)"}) {
        CHECK(abs(at(quarter, {1, 0}) - Point{0, 1}) < 1e-15);
    }
    CHECK(at("scaleX(2) scaleY(50%)", {1, 1}) == Point{2, 0.5});
    CHECK(at("none", {1, 1}) == Point{1, 1});
    CHECK_FALSE(parse_css_transform("rotate3d(1,1,1,45deg)", units, box).map);
    const auto origin = [&](std::string_view text) { return parse_transform_origin(text, units, box).value(); };
    CHECK(origin("center") == Point{60, 120});
    CHECK(origin("left top") == Point{10, 20});
    CHECK(origin("bottom right") == Point{110, 220});
    CHECK(origin("10px 50%") == Point{20, 120});
    CHECK(origin("top") == Point{60, 20});
    CHECK_FALSE(parse_transform_origin("left left", units, box));
    CHECK_FALSE(parse_transform_origin("", units, box));
}

TEST_CASE("a view box is fitted, sliced or stretched into its viewport") {
    const ViewBox box = parse_view_box("-10, 0 100 50").value();
    const auto corners = [&](const char* aspect) {
        const Affine map = view_box_map(box, parse_aspect_ratio(aspect).value(), 300, 300);
        return std::pair(apply(map, {-10, 0}), apply(map, {90, 50}));
    };
    CHECK(corners("xMidYMid meet") == std::pair(Point{0, 75}, Point{300, 225}));
    CHECK(corners("xMinYMax") == std::pair(Point{0, 150}, Point{300, 300}));
    CHECK(corners("xMaxYMin slice") == std::pair(Point{-300, 0}, Point{300, 300}));
    CHECK(corners("none") == std::pair(Point{0, 0}, Point{300, 300}));
    for (const char* text : {"0 0 1", "0 0 -1 1", "a", "0 0 1 1 1"}) CHECK_FALSE(parse_view_box(text));
    for (const char* text : {"", "xMid", "xMidYMid fit", "XMIDYMID", "none meet x"}) CHECK_FALSE(parse_aspect_ratio(text));
}
