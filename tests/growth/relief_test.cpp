// Density pictures from PNG and height maps to PNG, by libpng itself; the relief's heights, and that tiles have no seam.

#include <png.h>

#include <cmath>
#include <cstdint>

#include <catch2/catch.hpp>

#include "geometry/angle.h"
#include "growth/aggregate/density_picture_png.h"
#include "growth/aggregate/height_map.h"
#include "growth/aggregate/height_picture_png.h"
#include "growth/aggregate/smooth_distance.h"
#include "scene/input_error.h"

namespace rinceau {
namespace {

/// PNG bytes of a picture two pixels wide and one high.
template <class Sample>
std::string two_pixels(png_uint_32 format, const std::vector<Sample>& samples) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = 2;
    image.height = 1;
    image.format = format;
    png_alloc_size_t size = 0;
    REQUIRE(png_image_write_to_memory(&image, nullptr, &size, 0, samples.data(), 0, nullptr) != 0);
    std::string bytes(size, '\0');
    REQUIRE(png_image_write_to_memory(&image, bytes.data(), &size, 0, samples.data(), 0, nullptr) != 0);
    bytes.resize(size);
    return bytes;
}

std::vector<double> densities(const std::string& bytes) { return read_density_png(bytes, {{0, 0}, {2, 1}}, "p.png").values; }

Region square(double half) { return {{{-half, -half}, {half, -half}, {half, half}, {-half, half}}}; }

Region circle(double radius) {
    Region region(1);
    for (int i = 0; i < 200; ++i) region[0].push_back(polar(radius, two_pi * i / 200));
    return region;
}

double at(const HeightMap& map, int column, int row) {
    return map
        .heights[static_cast<std::size_t>(row) * static_cast<std::size_t>(map.columns) + static_cast<std::size_t>(column)];
}

}  // namespace

TEST_CASE("The darkness of a PNG is its density, whatever its colours, bits and opacity are") {
    using Bytes = std::vector<std::uint8_t>;
    CHECK(densities(two_pixels(PNG_FORMAT_GRAY, Bytes{0, 255})) == std::vector<double>{1, 0});
    const auto grey = densities(two_pixels(PNG_FORMAT_GRAY, Bytes{64, 128}));
    CHECK(grey[0] == Approx(1 - 64 / 255.0).margin(2e-3));
    CHECK(grey[1] == Approx(1 - 128 / 255.0).margin(2e-3));
    const auto rgb = densities(two_pixels(PNG_FORMAT_RGB, Bytes{128, 128, 128, 255, 255, 0}));
    CHECK(rgb[0] == Approx(1 - 128 / 255.0).margin(2e-3));
    CHECK(rgb[1] > 0);
    CHECK(rgb[1] < 0.1);  // yellow is bright
    // Black, transparent and half so.
    const auto clear = densities(two_pixels(PNG_FORMAT_RGBA, Bytes{0, 0, 0, 0, 0, 0, 0, 255}));
    CHECK(clear == std::vector<double>{0, 1});
    // 16 bits of light: half the light looks brighter than half grey.
    const auto linear = densities(two_pixels(PNG_FORMAT_LINEAR_Y, std::vector<std::uint16_t>{32768, 65535}));
    CHECK(linear[0] == Approx(1 - 0.7354).margin(0.01));
    CHECK(linear[1] == Approx(0).margin(1e-6));
}

TEST_CASE("What is no PNG is refused in the name of its file") {
    CHECK_THROWS_WITH(densities("GIF89a"), Catch::StartsWith("p.png: expected a PNG picture"));
    std::string cut = two_pixels(PNG_FORMAT_GRAY, std::vector<std::uint8_t>{1, 2});
    cut.resize(cut.size() - 20);
    CHECK_THROWS_AS(densities(cut), InputError);
}

TEST_CASE("The smooth distance is the true one at the edge, has no crease inside, and knows holes") {
    const Region disc = oriented(circle(10));
    CHECK(smooth_inside_distance(disc, {0, 0}) == Approx(10 / pi).epsilon(1e-3));
    CHECK(smooth_inside_distance(disc, {9.99, 0}) == Approx(0.01).epsilon(0.05));
    // Across the diagonal of a square the true distance has a crease; this one's slope does not jump.
    const Region box = oriented(square(10));
    const double step = 1e-4;
    const auto slope = [&](double x) {
        return (smooth_inside_distance(box, {x + step, 5}) - smooth_inside_distance(box, {x - step, 5})) / (2 * step);
    };
    CHECK(slope(5 - 0.01) == Approx(slope(5 + 0.01)).epsilon(0.02));
    Region ring = circle(10);
    ring.push_back(circle(4)[0]);  // the same way around: oriented() turns it
    CHECK(smooth_inside_distance(oriented(ring), {4.01, 0}) == Approx(0.01).epsilon(0.05));
    CHECK(outline_distance_at(ring, {7, 0}) == Approx(3).epsilon(1e-3));
}

TEST_CASE("A relief rises over its shapes and sinks between them") {
    const PackDomain domain{.box = {{0, 0}, {100, 50}}};
    const std::vector<PlacedRegion> placed{{0, {{1, 0}, {25, 25}}}, {0, {{0.5, 0}, {75, 25}}}};
    const HeightMap map = height_map({circle(20)}, {}, placed, domain, {.columns = 200, .depth = 0.4});
    REQUIRE(map.rows == 100);
    CHECK(map.rise == Approx(20 / pi).epsilon(0.01));
    CHECK(at(map, 50, 50) == Approx(1).epsilon(1e-3));  // the middle of the large one
    CHECK(at(map, 150, 50) < at(map, 50, 50));          // a small one is as steep, and lower
    CHECK(at(map, 150, 50) > 0.4);
    CHECK(at(map, 0, 0) == 0);                           // far from both
    CHECK(at(map, 90, 50) == Approx(0.4).margin(0.02));  // near an edge both sides meet
    CHECK(at(map, 88, 50) > at(map, 92, 50));
    // Sulci of their own lower what they lie on, and nothing else.
    const HeightMap sunk = height_map({circle(20)}, {circle(5)}, placed, domain, {.columns = 200, .depth = 0.4});
    CHECK(at(sunk, 50, 50) < at(map, 50, 50) - 0.1);
    CHECK(at(sunk, 70, 50) == at(map, 70, 50));
}

TEST_CASE("The relief of a tile has no seam: it only moves when its shapes move over the border") {
    const PackDomain tile{.box = {{0, 0}, {64, 32}}, .tiled = true};
    std::vector<PlacedRegion> placed{{0, {polar(1, 0.3), {10, 8}}}, {0, {polar(0.7, 1), {40, 20}}}};
    const HeightMapOptions options{.columns = 128};
    const HeightMap map = height_map({square(8)}, {}, placed, tile, options);
    constexpr int across = 28, down = 20;  // pixels of half a unit
    for (PlacedRegion& region : placed) {
        Point& p = region.pose.translation;
        p = {std::fmod(p.x + across / 2.0, 64), std::fmod(p.y - down / 2.0 + 32, 32)};
    }
    const HeightMap moved = height_map({square(8)}, {}, placed, tile, options);
    double worst = 0;
    for (int row = 0; row < map.rows; ++row)
        for (int column = 0; column < map.columns; ++column)
            worst = std::max(worst, std::abs(at(map, column, row) - at(moved, (column + across) % 128, (row + down) % 64)));
    CHECK(worst < 1e-9);
    CHECK(shaded_relief(map, {.tiled = true}).rgb.size() == 3u * 128 * 64);
}

TEST_CASE("A height map's PNG holds its heights in 16 bits and says nothing of gamma") {
    const HeightMap map{3, 1, {0, 0.5, 1}, {{0, 0}, {3, 1}}, 1};
    const std::string bytes = height_png(map);
    CHECK(bytes.find("gAMA") == std::string::npos);
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    REQUIRE(png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) != 0);
    CHECK(image.width == 3);
    CHECK(image.height == 1);
    image.format = PNG_FORMAT_LINEAR_Y;
    std::vector<std::uint16_t> pixels(3);
    REQUIRE(png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr) != 0);
    CHECK(pixels == std::vector<std::uint16_t>{0, 32768, 65535});
}

}  // namespace rinceau
