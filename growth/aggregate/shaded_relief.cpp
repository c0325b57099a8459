// A height map in the light of one lamp: Lambert and Blinn-Phong, low places darker.

#include <algorithm>
#include <array>
#include <cmath>

#include "growth/aggregate/height_map.h"
#include "growth/mesh/triangle_mesh.h"

namespace rinceau {
namespace {

/// Index of a neighbour, over the border in a tile.
int neighbour(int i, int count, bool tiled) { return tiled ? (i + count) % count : std::clamp(i, 0, count - 1); }

std::uint8_t to_byte(double value) { return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0))); }

}  // namespace

Picture shaded_relief(const HeightMap& map, const ReliefLook& look) {
    const SpacePoint light = unit({-0.55, 0.6, 0.75}), eye{0, 0, 1};
    const SpacePoint half_way = unit(light + eye);
    constexpr double ambient = 0.35, diffuse = 0.75, gloss = 45, shine = 30;  // gloss of 255
    const double relief = look.relief * map.rise;
    const double step = width(map.box) / map.columns;
    const auto height_at = [&](int column, int row) {
        const auto c = static_cast<std::size_t>(neighbour(column, map.columns, look.tiled));
        const auto r = static_cast<std::size_t>(neighbour(row, map.rows, look.tiled));
        return map.heights[r * static_cast<std::size_t>(map.columns) + c];
    };
    Picture picture{map.columns, map.rows, {}};
    picture.rgb.reserve(3 * map.heights.size());
    for (int row = 0; row < map.rows; ++row)
        for (int column = 0; column < map.columns; ++column) {
            const double east = height_at(column + 1, row) - height_at(column - 1, row);
            const double north = height_at(column, row - 1) - height_at(column, row + 1);
            const SpacePoint normal = unit({-relief * east / (2 * step), -relief * north / (2 * step), 1});
            const double open = 0.45 + 0.55 * height_at(column, row);  // deep places see less of the sky
            const double lit = open * (ambient + diffuse * std::max(0.0, dot(normal, light)));
            const double glint = open * gloss * std::pow(std::max(0.0, dot(normal, half_way)), shine);
            for (const std::uint8_t channel : {look.base.red, look.base.green, look.base.blue})
                picture.rgb.push_back(to_byte(lit * channel + glint));
        }
    return picture;
}

}  // namespace rinceau
