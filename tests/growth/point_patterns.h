#pragma once
// Points in patterns whose neighbours are known.

#include <cmath>
#include <string>
#include <vector>

#include "geometry/angle.h"
#include "geometry/random.h"
#include "growth/arrangement/exemplar.h"

namespace rinceau {

struct KnownPattern {
    std::string name;
    std::vector<ExemplarPoint> points;
    std::size_t degree = 0;  ///< neighbours that each point inside has
};

inline std::vector<ExemplarPoint> grid_points(int columns, int rows, Point column, Point row, double stagger = 0) {
    std::vector<ExemplarPoint> points;
    for (int v = 0; v < rows; ++v)
        for (int u = 0; u < columns; ++u)
            points.push_back({.position = (u + (v % 2 != 0 ? stagger : 0)) * column + static_cast<double>(v) * row});
    return points;
}

inline std::vector<ExemplarPoint> honeycomb_points(int columns, int rows) {
    std::vector<ExemplarPoint> points;
    for (int v = 0; v < rows; ++v)
        for (int u = 0; u < columns; ++u)
            for (const double up : {0.0, 1.0})
                points.push_back({.position = {std::sqrt(3.0) * (u + 0.5 * (v % 2)), 1.5 * v + up}});
    return points;
}

inline KnownPattern turned(KnownPattern pattern, double angle) {
    pattern.name += " turned";
    for (ExemplarPoint& p : pattern.points) p.position = polar(1, angle) * p.position;
    return pattern;
}

/// Each point moved by up to `share` in x and y.
inline KnownPattern jittered(KnownPattern pattern, double share, std::uint64_t seed) {
    Random random(seed);
    for (ExemplarPoint& p : pattern.points) p.position += {random.uniform(-share, share), random.uniform(-share, share)};
    return pattern;
}

/// Square, hexagonal, honeycomb, brick bond, diagonal scales, checkerboard; edges near 1.
inline std::vector<KnownPattern> lattice_patterns() {
    const double row = std::sqrt(0.75);
    std::vector<KnownPattern> patterns{
        {"square", grid_points(8, 8, {1, 0}, {0, 1}), 4},
        {"hexagonal", grid_points(8, 8, {1, 0}, {0, row}, 0.5), 6},
        {"honeycomb", honeycomb_points(6, 6), 3},
        {"brick bond", grid_points(7, 9, {2, 0}, {0, 0.8}, 0.5), 6},
        {"scales", grid_points(8, 12, {1.2, 0}, {0, 0.6}, 0.5), 4},
        {"checkerboard", grid_points(8, 8, {1, 0}, {0, 1}), 4},
    };
    for (std::size_t i = 0; i < patterns.back().points.size(); ++i)
        patterns.back().points[i].symbol = static_cast<int>((i + i / 8) % 2);
    return patterns;
}

/// Points that keep `least` from each other in a box of the given size, thrown at random.
inline std::vector<ExemplarPoint> scattered_points(double size, double least, int throws, std::uint64_t seed) {
    Random random(seed);
    std::vector<ExemplarPoint> points;
    for (int i = 0; i < throws; ++i) {
        const Point at{random.uniform(0, size), random.uniform(0, size)};
        bool free = true;
        for (const ExemplarPoint& p : points) free = free && abs(p.position - at) >= least;
        if (free) points.push_back({.position = at});
    }
    return points;
}

}  // namespace rinceau
