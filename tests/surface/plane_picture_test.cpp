#include "growth/surface/plane_picture.h"

#include <catch2/catch.hpp>

#include "growth/surface/surface_field.h"
#include "scene/input_error.h"
#include "surface_shapes.h"

using namespace rinceau;

namespace {

/// Grey value of every pixel from shade(x, y) in [0, 1], y up from the middle of the lowest row.
template <class Shade>
Picture shaded_picture(int width, int height, Shade shade) {
    Picture picture{width, height, {}};
    for (int row = 0; row < height; ++row)
        for (int x = 0; x < width; ++x) {
            const double value = shade(x, height - 1 - row);
            picture.rgb.insert(picture.rgb.end(), 3, static_cast<std::uint8_t>(std::lround(255 * value)));
        }
    return picture;
}

}  // namespace

TEST_CASE("the way along a picture's stripes is found at every angle") {
    for (const double angle : {0.0, 0.3, 1.0, 1.9, 2.8}) {
        const Complex across = polar(1, angle + pi / 2);
        const Picture stripes =
            shaded_picture(96, 64, [&](int x, int y) { return 0.5 + 0.4 * std::sin(0.5 * (across.x * x + across.y * y)); });
        const PlanePicture placed = plane_picture(stripes, {{0, 0}, {96, 64}}, {}, "stripes.png");
        for (const Point p : {Point{30, 20}, Point{48, 32}, Point{70.3, 41.9}})
            CHECK(degrees(std::abs(wrap_angle(arg(edges_along(placed, p)) - 2 * angle))) / 2 < 0.2);
    }
}

TEST_CASE("rings are followed round, and flat parts take the way of the nearest edge") {
    const Picture ring = shaded_picture(101, 101, [](int x, int y) { return std::hypot(x - 50, y - 50) < 20 ? 0.0 : 1.0; });
    const PlanePicture placed = plane_picture(ring, {{0, 0}, {1, 1}}, {}, "ring.png");
    for (int i = 0; i < 24; ++i) {
        const double way = two_pi * i / 24;
        const auto off = [&](double radius) {
            const Point p = Point{0.5, 0.5} + polar(radius / 101, way);
            return degrees(std::abs(wrap_angle(arg(edges_along(placed, p)) - 2 * way - pi))) / 2;
        };
        CHECK(off(20) < 2.5);  // of a rim of whole pixels
        CHECK(off(38) < 12);   // nothing but white there
    }
}

TEST_CASE("a picture lies in the middle of its box, as large as fits, and is read between its pixels") {
    Picture picture{2, 1, {255, 0, 0, 0, 0, 255}};
    const PlanePicture placed = plane_picture(picture, {{0, 0}, {4, 10}}, {}, "two.png");
    CHECK(placed.box == Box{{0, 4}, {4, 6}});
    CHECK(pixel_side(placed) == 2);
    CHECK(colour_at(placed, {1, 5}) == std::array<double, 3>{255, 0, 0});
    CHECK(colour_at(placed, {3, 9}) == std::array<double, 3>{0, 0, 255});
    CHECK(colour_at(placed, {2, 5})[0] == Approx(127.5));
    CHECK(brightness_at(placed, {-5, 5}) == Approx(0.2126));
    CHECK_THROWS_WITH(plane_picture({}, {{0, 0}, {1, 1}}, {}, "none.png"), Catch::Contains("none.png"));
    CHECK_THROWS_AS(plane_picture(picture, {{0, 0}, {1, 1}}, {1, -2}, "two.png"), InputError);
}

TEST_CASE("a field along a picture knows its pixels however coarse the surface is, and its colours") {
    const Picture stripes = shaded_picture(80, 80, [](int x, int) { return 0.5 + 0.5 * std::sin(0.6 * x); });
    const SurfaceMesh surface = surface_mesh(plane_triangles(1, 1, 80));
    const auto placed = std::make_shared<const PlanePicture>(plane_picture(stripes, {{0, 0}, {80, 80}}, {}, "s.png"));
    const FieldOnSurface field(surface, {.n = 2, .picture = placed, .along_picture = true});
    Random random(5);
    for (int i = 0; i < 50; ++i) {
        const SurfacePoint p = random_surface_point(surface, random);
        const SpacePoint way = direction_in_space(surface, p.face, root_near(field.at(p), 2, {1, 0}));
        CHECK(std::abs(way.x) < 0.01);
        const SpacePoint place = position_in_space(surface, p);
        CHECK(field.scalar_at(p) == Approx(0.5 + 0.5 * std::sin(0.6 * (place.x - 0.5))).margin(0.06));
        CHECK((*field.colour_at(p))[1] == Approx(255 * field.scalar_at(p)));
    }
    CHECK_THROWS_WITH(FieldOnSurface(surface, {.n = 4, .picture = placed, .along_picture = true}), Catch::Contains("n = 2"));
}
