#include "growth/distance_transform.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>

#include "geometry/random.h"

using namespace rinceau;

TEST_CASE("Distances on a raster are those to the nearest marked cell") {
    constexpr int columns = 37, rows = 23;
    Random random(3);
    std::vector<std::uint8_t> marked(columns * rows);
    for (auto& cell : marked) cell = random.uniform() < 0.02 ? 1 : 0;
    const std::vector<double> distances = squared_distances(marked, columns, rows);
    int wrong = 0;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            double nearest = std::numeric_limits<double>::infinity();
            for (int r = 0; r < rows; ++r)
                for (int c = 0; c < columns; ++c)
                    if (marked[static_cast<std::size_t>(r * columns + c)] != 0)
                        nearest = std::min(nearest, 1.0 * (r - row) * (r - row) + 1.0 * (c - column) * (c - column));
            if (distances[static_cast<std::size_t>(row * columns + column)] != nearest) ++wrong;
        }
    }
    CHECK(wrong == 0);
}

TEST_CASE("Nothing marked is infinitely far") {
    const std::vector<double> distances = squared_distances(std::vector<std::uint8_t>(6), 3, 2);
    CHECK(std::all_of(distances.begin(), distances.end(),
                      [](double d) { return d == std::numeric_limits<double>::infinity(); }));
}
