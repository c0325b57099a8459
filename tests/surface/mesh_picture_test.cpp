#include "growth/mesh/mesh_picture.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>

#include "growth/mesh/depth_occlusion.h"
#include "surface_shapes.h"

using namespace rinceau;

namespace {

constexpr double nothing = -std::numeric_limits<double>::infinity();

DepthImage flat_image(int side) {
    const auto count = static_cast<std::size_t>(side) * static_cast<std::size_t>(side);
    return {side, side, std::vector<double>(count, 0), std::vector<std::array<float, 3>>(count, {0, 0, 1})};
}

int brightness(const Picture& picture, int x, int y) {
    const auto i = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x));
    return picture.rgb[i] + picture.rgb[i + 1] + picture.rgb[i + 2];
}

/// A floor with a block upon it, of the same colour, seen from above.
MeshAssembly block_on_floor() {
    MeshAssembly assembly{
        .meshes = {{"floor", plane_triangles(1, 1, 10), {200, 200, 200}, {}}, {"block", {}, {200, 200, 200}, {}}}};
    TriangleMesh& block = assembly.meshes[1].mesh;
    for (int i = 0; i < 8; ++i) block.positions.push_back({4.0 + 2 * (i & 1), 4.0 + (i & 2), 0.4 * (i >> 2)});
    block.triangles = {{4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4}, {2, 6, 3},
                       {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    assembly.instances = {{0, {}}, {1, {}}};
    return assembly;
}

}  // namespace

TEST_CASE("An open plane sees all of the sky, level or slanted, and so does nothing's border") {
    DepthImage image = flat_image(60);
    for (const float sky : open_sky(image, 20)) CHECK(sky == 1);
    const float s = std::sqrt(0.5F);
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 60; ++x) {
            const auto i = static_cast<std::size_t>(60 * y + x);
            image.depth[i] = x < 10 ? nothing : x;
            image.normals[i] = {-s, 0, s};
        }
    for (const float sky : open_sky(image, 20)) CHECK(sky == 1);
}

TEST_CASE("Beside a step it is darker below, not above, and far from it it is not") {
    DepthImage image = flat_image(80);
    for (std::size_t i = 0; i < image.depth.size(); ++i) image.depth[i] = i % 80 < 40 ? 8 : 0;
    const std::vector<float> sky = open_sky(image, 12);
    const auto at = [&](std::size_t x) { return static_cast<double>(sky[80 * 40 + x]); };
    CHECK(at(41) < 0.7);
    CHECK(at(44) < at(50));
    CHECK(at(39) == 1);
    CHECK(at(60) == 1);
}

TEST_CASE("A picture's occlusion darkens the floor beside a block of its own colour, and without it both look alike") {
    const MeshAssembly assembly = block_on_floor();
    const MeshView above{.elevation = pi / 2, .width = 100};
    const Picture plain = mesh_picture(assembly, UpAxis::z, above);
    MeshView cloudy = above;
    cloudy.occlusion = 1;
    const Picture shaded = mesh_picture(assembly, UpAxis::z, cloudy);
    REQUIRE(plain.width == 100);
    REQUIRE(plain.height == 100);
    CHECK(brightness(plain, 50, 50) == brightness(plain, 50, 64));
    const int open = brightness(shaded, 20, 20), beside = brightness(shaded, 50, 61);
    CHECK(beside < 0.95 * open);
    CHECK(brightness(shaded, 50, 60) < beside);
    CHECK(brightness(shaded, 50, 50) == open);
}

TEST_CASE("An eye that goes round sees what a turned thing shows, and a given height fits all in") {
    MeshAssembly still{.meshes = {{"m", torus_triangles(20, 9, 2, 0.7), {90, 160, 220}, {}}}};
    for (SpacePoint& p : still.meshes[0].mesh.positions) p = {p.x, 1.7 * p.y, p.z + 0.5 * p.x};
    MeshAssembly turned = still;
    const double angle = 0.8;
    still.instances = {{0, {}}};
    turned.instances = {{0, {.rotation = rotation_about({0, 0, 1}, -angle)}}};
    const MeshView front{.elevation = 0.4, .width = 120};
    MeshView round = front;
    round.turn = angle;
    const Picture a = mesh_picture(still, UpAxis::z, round), b = mesh_picture(turned, UpAxis::z, front);
    REQUIRE(a.width == b.width);
    REQUIRE(a.height == b.height);
    std::size_t differing = 0;
    for (std::size_t i = 0; i < a.rgb.size(); ++i) differing += std::abs(a.rgb[i] - b.rgb[i]) > 8 ? 1 : 0;
    CHECK(differing < a.rgb.size() / 200);
    round.height = 50;
    const Picture low = mesh_picture(still, UpAxis::z, round);
    CHECK(low.height == 50);
    const auto white = [&](int x, int y) { return brightness(low, x, y) == 3 * 255; };
    for (int x = 0; x < low.width; ++x) CHECK((white(x, 0) && white(x, low.height - 1)));
}
