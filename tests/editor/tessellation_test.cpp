#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

#include "geometry/polygon.h"
#include "geometry/random.h"
#include "mesh_picture.h"
#include "scene/painted_region.h"
#include "scene/svg_raster.h"
#include "scene/svg_read.h"
#include "scene/svg_write.h"

using namespace rinceau;

namespace {

Path polygon(const std::vector<Point>& corners, bool closed = true) {
    Path path{corners.front(), {}, closed};
    for (std::size_t i = 1; i < corners.size(); ++i) path.segments.push_back(line_to(corners[i]));
    return path;
}

Path square(double half) { return polygon({{-half, -half}, {half, -half}, {half, half}, {-half, half}}); }

Path pentagram() {
    std::vector<Point> corners;
    for (int i = 0; i < 5; ++i) corners.push_back(polar(1, 0.8 * pi * i));
    return polygon(corners);
}

Path random_polygon(Random& random, int corners) {
    std::vector<Point> points;
    for (int i = 0; i < corners; ++i) points.push_back({random.uniform(0, 100), random.uniform(0, 100)});
    return polygon(points);
}

Style filled(FillRule rule) {
    Style style;
    style.fill_rule = rule;
    return style;
}

Style stroked(double width, LineCap cap = LineCap::butt, LineJoin join = LineJoin::miter) {
    Style style;
    style.fill = NoPaint{};
    style.stroke = {.paint = Color{}, .width = width, .cap = cap, .join = join};
    return style;
}

double fill_area(const std::vector<Path>& paths, FillRule rule = FillRule::nonzero) {
    const DrawMesh mesh = tessellated(paths, filled(rule), {.deviation = 1e-4});
    CHECK(smallest_triangle(mesh, mesh.fill) > -1e-6);
    return mesh_area(mesh, mesh.fill);
}

double stroke_area(const std::vector<Path>& paths, const Style& style, const MeshOptions& options = {.deviation = 1e-4}) {
    const DrawMesh mesh = tessellated(paths, style, options);
    CHECK(mesh.fill.empty());
    CHECK(smallest_triangle(mesh, mesh.stroke) > -1e-6);
    return mesh_area(mesh, mesh.stroke);
}

Path line(double length) { return polygon({{0, 0}, {length, 0}}, false); }

/// The share of inked pixels in which the meshes of an SVG differ from what librsvg draws.
double difference_from_librsvg(const std::string& content) {
    const std::string svg =
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100' width='100' height='100'>" + content + "</svg>";
    constexpr int pixels = 250;
    const double unit = 100.0 / pixels;
    return picture_difference(mesh_picture(read_svg(svg).scene, unit, 0.1 * unit), svg_to_picture(svg, pixels));
}

}  // namespace

TEST_CASE("fills have the areas that their rules give") {
    // A pentagram in the unit circle (known values), and a ring of two squares.
    CHECK(fill_area({pentagram()}, FillRule::nonzero) == Approx(1.122570).epsilon(1e-5));
    CHECK(fill_area({pentagram()}, FillRule::evenodd) == Approx(0.775677).epsilon(1e-5));
    CHECK(fill_area({square(2), square(1)}, FillRule::evenodd) == Approx(12));
    CHECK(fill_area({square(2), square(1)}, FillRule::nonzero) == Approx(16));
    const Path hole = polygon({{-1, -1}, {-1, 1}, {1, 1}, {1, -1}});
    CHECK(fill_area({square(2), hole}, FillRule::nonzero) == Approx(12));
    CHECK(fill_area({polygon({{0, 0}, {3, 0}, {3, 4}}, false)}) == Approx(6));
}

TEST_CASE("lines, caps and dots have the areas of their outlines") {
    CHECK(stroke_area({line(10)}, stroked(2)) == Approx(20));
    CHECK(stroke_area({line(10)}, stroked(2, LineCap::square)) == Approx(24));
    CHECK(stroke_area({line(10)}, stroked(2, LineCap::round)) == Approx(20 + pi).epsilon(1e-3));
    const Path dot = polygon({{3, 4}, {3, 4}}, false);
    CHECK(stroke_area({dot}, stroked(2)) == 0);
    CHECK(stroke_area({dot}, stroked(2, LineCap::square)) == Approx(4));
    CHECK(stroke_area({dot}, stroked(2, LineCap::round)) == Approx(pi).epsilon(1e-3));
    CHECK(stroke_area({Path{{3, 4}, {}, true}}, stroked(2, LineCap::round)) == Approx(pi).epsilon(1e-3));
    CHECK(stroke_area({Path{{3, 4}, {}, false}}, stroked(2, LineCap::round)) == 0);
}

TEST_CASE("joins have the areas of their outlines") {
    CHECK(stroke_area({square(5)}, stroked(2)) == Approx(144 - 64));
    CHECK(stroke_area({square(5)}, stroked(2, LineCap::butt, LineJoin::bevel)) == Approx(144 - 64 - 4 * 0.5));
    CHECK(stroke_area({square(5)}, stroked(2, LineCap::butt, LineJoin::round)) == Approx(140 - 64 + pi).epsilon(1e-3));
    Style sharp = stroked(2);
    sharp.stroke.miter_limit = 1.4;  // a right angle's is the root of 2
    CHECK(stroke_area({square(5)}, sharp) == Approx(144 - 64 - 4 * 0.5));
}

TEST_CASE("dashes cover what their lengths say, from their offset on") {
    Style style = stroked(1);
    style.stroke.dashes = {3, 2};
    CHECK(stroke_area({line(10)}, style) == Approx(6));
    style.stroke.dash_offset = 2;
    CHECK(stroke_area({line(10)}, style) == Approx(1 + 3 + 2));
    style.stroke.dash_offset = -1;
    CHECK(stroke_area({line(10)}, style) == Approx(3 + 3));
    style.stroke.dashes = {0, 2};
    style.stroke.dash_offset = 0;
    style.stroke.cap = LineCap::round;
    CHECK(stroke_area({line(9)}, style) == Approx(5 * 0.25 * pi).epsilon(2e-3));
    style.stroke.dashes = {0, 0};
    style.stroke.cap = LineCap::butt;
    CHECK(stroke_area({line(9)}, style) == Approx(9));
}

TEST_CASE("a dash runs on over the start of a closed path") {
    Style style = stroked(2);
    style.stroke.dashes = {10, 10};
    style.stroke.dash_offset = 5;
    // 40 round: dashes over the corners of the start and of its opposite, both mitred.
    CHECK(stroke_area({square(5)}, style) == Approx(2 * (2 * 10 - 1 + 1)));
}

TEST_CASE("where a stroke meets itself it covers once") {
    const Path cross_shape = polygon({{-5, 0}, {5, 0}, {5, 20}, {0, 20}, {0, -5}}, false);
    CHECK(stroke_area({cross_shape}, stroked(1)) == Approx(10 + 20 + 5 + 25 - 1));
    // Back upon itself.
    CHECK(stroke_area({polygon({{0, 0}, {10, 0}, {4, 0}}, false)}, stroked(2)) == Approx(20));
    // A pen wider than the circle that it draws leaves no hole.
    const Scene circle = read_svg("<svg xmlns='http://www.w3.org/2000/svg'><circle r='2'/></svg>").scene;
    CHECK(stroke_area(circle.elements.at(0).paths, stroked(10)) == Approx(49 * pi).epsilon(1e-3));
}

TEST_CASE("a fixed stroke has its width in the scene, and a pen stretches the rest") {
    Style style = stroked(2);
    style.stroke.fixed = true;
    CHECK(stroke_area({line(10)}, style, {.deviation = 1e-4, .stroke_scale = 4}) == Approx(5));
    Style stretched = stroked(2);
    stretched.stroke.pen = {2, 0, 0, 0.5};
    CHECK(stroke_area({line(10)}, stretched) == Approx(10));
    CHECK(stroke_area({polygon({{0, 0}, {0, 10}}, false)}, stretched) == Approx(40));
}

TEST_CASE("triangles of polygons of all sizes do not overlap and fill the region of the polygon") {
    Random random(11);
    for (const FillRule rule : {FillRule::nonzero, FillRule::evenodd}) {
        for (const int corners : {5, 30, 60, 150}) {
            const std::vector<Path> paths{random_polygon(random, corners), random_polygon(random, 4)};
            CHECK(fill_area(paths, rule) == Approx(area(enclosed_region(paths, rule, 1e-4))).epsilon(1e-4));
        }
    }
}

TEST_CASE("an outline of many corners keeps its area") {
    constexpr int corners = 20'000;
    std::vector<Point> points;
    for (int i = 0; i < corners; ++i) points.push_back(polar(50 + i % 2, 2 * pi * i / corners));
    CHECK(fill_area({polygon(points)}) == Approx(0.5 * corners * 50 * 51 * std::sin(2 * pi / corners)).epsilon(1e-4));
}

TEST_CASE("outlines that cross themselves without end are coarse, not slow") {
    Random random(5);
    const Path scribble = random_polygon(random, 3000);
    const DrawMesh mesh = tessellated({scribble}, filled(FillRule::nonzero));
    CHECK(mesh.fill.size() < 3 * 500'000);
    const std::vector<Point> corners = flattened(scribble, 1);
    constexpr int probes = 2000;
    int inside = 0;
    for (int i = 0; i < probes; ++i)
        inside += winding_number(corners, {random.uniform(0, 100), random.uniform(0, 100)}) != 0 ? 1 : 0;
    CHECK(mesh_area(mesh, mesh.fill) == Approx(1e4 * inside / probes).epsilon(0.03));
}

TEST_CASE("degenerate outlines give no triangles and no trouble") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const Style both = [] {
        Style style = stroked(1, LineCap::butt, LineJoin::round);
        style.fill = Color{};
        return style;
    }();
    const std::vector<std::vector<Path>> nothing{{},
                                                 {Path{}},
                                                 {polygon({{1, 1}, {1, 1}, {1, 1}})},
                                                 {polygon({{nan, 1}, {2, 1}, {1, 5}})},
                                                 {polygon({{0, 0}, {std::numeric_limits<double>::infinity(), 1}, {1, 5}})}};
    for (const std::vector<Path>& paths : nothing) {
        const DrawMesh mesh = tessellated(paths, both);
        CHECK(mesh.fill.empty());
        CHECK(mesh.stroke.empty());
    }
    Style flat = both;
    flat.stroke.pen = {1, 0, 0, 0};
    flat.stroke.dashes = {-1, 2};
    CHECK(tessellated({square(1)}, flat).stroke.empty());
    CHECK(is_empty(tessellated({square(1)}, stroked(0)).box));
}

TEST_CASE("a mesh does not change from one call to the next") {
    Style style = stroked(3, LineCap::round, LineJoin::round);
    style.fill = Color{};
    style.stroke.dashes = {5, 2};
    const DrawMesh once = tessellated({pentagram(), square(3)}, style);
    const DrawMesh again = tessellated({pentagram(), square(3)}, style);
    CHECK(once.points == again.points);
    CHECK(once.fill == again.fill);
    CHECK(once.stroke == again.stroke);
}

TEST_CASE("strokes look as librsvg draws them") {
    const std::string shapes[] = {"M10 80 L30 20 L50 80 L60 10 L90 50", "M20 80 L50 20 L80 80 Z",
                                  "M20 80 C120 20 -20 20 80 80", "M10 80 C150 -20 -50 -20 90 80 Z"};
    const std::string looks[] = {"stroke-width='1'", "stroke-width='9' stroke-linecap='round' stroke-linejoin='round'",
                                 "stroke-width='9' stroke-linecap='square' stroke-linejoin='bevel' stroke-dasharray='14 6'",
                                 "stroke-width='6' stroke-dasharray='9 3 2 3' stroke-dashoffset='7'",
                                 "stroke-width='5' stroke-linecap='round' stroke-dasharray='0 9'"};
    for (const std::string& shape : shapes) {
        for (const std::string& look : looks) {
            INFO(shape << " " << look);
            CHECK(difference_from_librsvg("<path fill='none' stroke='#136' stroke-opacity='.6' " + look + " d='" + shape +
                                          "'/>") < 0.005);
        }
    }
    CHECK(difference_from_librsvg("<path transform='matrix(1 .3 .6 1 -30 -20)' fill='#fc0' stroke='#136' stroke-width='7' "
                                  "stroke-linejoin='round' d='M20 20 H70 V70 C50 90 30 40 20 60 Z'/>") < 0.005);
}
