#include "lsystem/lattice_noise.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "lsystem/draw_key.h"

namespace rinceau {

namespace {

constexpr std::size_t most_coordinates = 3;

struct Cell {
    std::array<std::uint64_t, most_coordinates> low{};
    std::array<double, most_coordinates> share{};  ///< of the upper end, blended
};

/// 6 t^5 - 15 t^4 + 10 t^3
double blended(double t) { return t * t * t * (t * (6 * t - 15) + 10); }

/// In [-1, 1).
double value_at(const Cell& cell, std::size_t coordinates, std::size_t corner) {
    DrawKey key = 0;
    for (std::size_t i = 0; i < coordinates; ++i) key = key_below(key, cell.low[i] + ((corner >> i) & 1U));
    return 2 * uniform_draw(key) - 1;
}

}  // namespace

double lattice_noise(std::span<const double> place) {
    Cell cell;
    for (std::size_t i = 0; i < place.size(); ++i) {
        if (!(std::abs(place[i]) < 0x1.0p52)) return std::numeric_limits<double>::quiet_NaN();
        const double low = std::floor(place[i]);
        cell.low[i] = static_cast<std::uint64_t>(static_cast<std::int64_t>(low));
        cell.share[i] = blended(place[i] - low);
    }
    double sum = 0;
    for (std::size_t corner = 0; corner < (std::size_t{1} << place.size()); ++corner) {
        double weight = 1;
        for (std::size_t i = 0; i < place.size(); ++i)
            weight *= ((corner >> i) & 1U) != 0 ? cell.share[i] : 1 - cell.share[i];
        sum += weight * value_at(cell, place.size(), corner);
    }
    return sum;
}

}  // namespace rinceau
