#pragma once
// Exemplars that tests grow from.

#include <cmath>
#include <string>
#include <vector>

#include "geometry/random.h"
#include "growth/arrangement/exemplar.h"

namespace rinceau {

struct LatticeKind {
    std::string name;
    std::size_t degree = 0;
    std::vector<std::string> symbols;
    std::vector<ExemplarPoint> points;
};

/// A regular polygon about its position.
inline Region disc_outline(double radius) {
    std::vector<Point> ring;
    for (int i = 0; i < 16; ++i) ring.push_back(polar(radius, two_pi * i / 16));
    return {ring};
}
inline Region box_outline(double wide, double high) {
    return {{{-wide / 2, -high / 2}, {wide / 2, -high / 2}, {wide / 2, high / 2}, {-wide / 2, high / 2}}};
}

/// Square grid, checkerboard, hexagonal, brick bond, honeycomb, staggered diagonal rows.
inline std::vector<LatticeKind> lattice_kinds() {
    constexpr int rows = 8;
    std::vector<LatticeKind> kinds{{"square", 4, {"A"}, {}},    {"checkerboard", 4, {"A", "B"}, {}},
                                   {"hexagonal", 6, {"A"}, {}}, {"brick bond", 6, {"A"}, {}},
                                   {"honeycomb", 3, {"A"}, {}}, {"diagonal", 4, {"A"}, {}}};
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < rows; ++column) {
            const double x = 10 * column;
            const double shift = row % 2 == 0 ? 0 : 5;
            kinds[0].points.push_back({{x, 10.0 * row}, 0, disc_outline(3)});
            kinds[1].points.push_back({{x, 10.0 * row}, (row + column) % 2, disc_outline(3)});
            kinds[2].points.push_back({{x + shift, 5 * std::sqrt(3.0) * row}, 0, disc_outline(4)});
            kinds[3].points.push_back({{3 * (x + shift), 10.0 * row}, 0, box_outline(29, 9)});
            const double side = 10 / std::sqrt(3.0);
            kinds[4].points.push_back({{x + shift, 1.5 * side * row}, 0, disc_outline(2)});
            kinds[4].points.push_back({{x + shift, (1.5 * row + 1) * side}, 0, disc_outline(2)});
            kinds[5].points.push_back({{x + shift, 6.0 * row}, 0, disc_outline(3)});
        }
    }
    return kinds;
}

/// So many large and small discs by dart throwing, as dense as they come without touching.
inline std::vector<ExemplarPoint> irregular_points(std::size_t count) {
    std::vector<ExemplarPoint> points;
    Random random(17);
    const double side = 11 * std::sqrt(static_cast<double>(count));
    for (int dart = 0; dart < 20'000 && points.size() < count; ++dart) {
        const Point at{random.uniform(0, side), random.uniform(0, side)};
        const int symbol = points.size() % 2 == 0 ? 0 : 1;
        const double radius = symbol == 0 ? 5 : 2.5;
        bool free = true;
        for (const ExemplarPoint& other : points)
            free &= abs(other.position - at) > radius + (other.symbol == 0 ? 5 : 2.5) + 1;
        if (free) points.push_back({at, symbol, disc_outline(radius)});
    }
    return points;
}

}  // namespace rinceau
