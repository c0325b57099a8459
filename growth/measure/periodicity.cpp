// Autocorrelation of the mask of all regions less its mean. Sums are divided by the whole domain, as is usual: divided by
// what the domain shares with its moved copy, long steps would be ruled by chance.

#include "growth/measure/periodicity.h"

#include <algorithm>
#include <cmath>

#include "growth/measure/mask.h"
#include "growth/measure/outline_overlaps.h"

namespace rinceau {
namespace {

constexpr double finest = 640;        ///< cells along the longer side, at least ..
constexpr double cells_a_shape = 16;  ///< .. or this many along `shortest`, whatever is more ..
constexpr double most_cells = 1600;   ///< .. up to this

/// A multiple of 32 cells along a side of that length: such lengths are transformed fast, and halves are whole.
int cells_along(double length, double cell) { return 32 * std::max(1, static_cast<int>(std::lround(length / cell / 32))); }

}  // namespace

RepeatingStep strongest_repeat(const std::vector<Region>& regions, const PackDomain& domain, double shortest) {
    const double longer = std::max(width(domain.box), height(domain.box));
    const double cell = longer / std::clamp(cells_a_shape * longer / shortest, finest, most_cells);
    const int columns = cells_along(width(domain.box), cell), rows = cells_along(height(domain.box), cell);
    // Cells are not quite square, so that they fit a tile: outlines are taken to the raster's own coordinates.
    const Point size{width(domain.box) / columns, height(domain.box) / rows};
    const auto on_raster = [&](Region region) {
        for (auto& ring : region)
            for (Point& p : ring) p = {(p.x - domain.box.low.x) / size.x, (p.y - domain.box.low.y) / size.y};
        return region;
    };
    const Mask empty{{0, 0},
                     1,
                     columns,
                     rows,
                     std::vector<std::uint8_t>(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows))};
    Mask covered = empty, ground = empty;
    for (const Region& region : regions) {
        const Region drawn = on_raster(region);
        for (int row = domain.tiled ? -1 : 0; row <= (domain.tiled ? 1 : 0); ++row)
            for (int column = domain.tiled ? -1 : 0; column <= (domain.tiled ? 1 : 0); ++column)
                covered = with_region(std::move(covered),
                                      placed_region(drawn, translate({1.0 * column * columns, 1.0 * row * rows})));
    }
    if (domain.region) {
        ground = with_region(std::move(ground), on_raster(*domain.region));
    } else {
        std::fill(ground.inside.begin(), ground.inside.end(), std::uint8_t{1});
    }
    double count = 0, mean = 0;
    for (std::size_t i = 0; i < ground.inside.size(); ++i)
        count += ground.inside[i], mean += ground.inside[i] & covered.inside[i];
    if (count == 0) return {};
    mean /= count;
    const double variance = mean * (1 - mean);
    if (variance == 0) return {};
    std::vector<double> values(ground.inside.size());
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = ground.inside[i] * (covered.inside[i] - mean);

    const int column_steps = columns / 2 - 1, row_steps = rows / 2 - 1;
    const SelfOverlap products = self_overlap(values, columns, rows, column_steps, row_steps, domain.tiled);
    RepeatingStep strongest;
    for (int row = 0; row <= row_steps; ++row)
        for (int column = -column_steps; column <= column_steps; ++column) {
            const Point step{column * size.x, row * size.y};
            if (abs(step) <= shortest) continue;
            const double value = products.at(column, row) / (count * variance);
            if (value > strongest.value) strongest = {step, value};
        }
    return strongest;
}

}  // namespace rinceau
