#include "growth/surface/shape_outlines.h"

#include "geometry/angle.h"

namespace rinceau {

std::vector<Point> round_outline(int corners) {
    std::vector<Point> ring;
    for (int i = 0; i < corners; ++i) ring.push_back(polar(0.5, two_pi * i / corners));
    return ring;
}

std::vector<Point> star_outline(int points, double inner) {
    std::vector<Point> ring;
    for (int i = 0; i < 2 * points; ++i) ring.push_back(polar(i % 2 == 0 ? 0.5 : 0.5 * inner, pi * i / points));
    return ring;
}

std::vector<Point> tile_outline(double radius, int steps) {
    if (radius <= 0) return {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}};
    std::vector<Point> ring;
    const double from_middle = 0.5 - radius;
    for (int corner = 0; corner < 4; ++corner) {
        const Complex quarter = polar(1, 0.5 * pi * corner);
        for (int i = 0; i <= steps; ++i) {
            const Point p = Point{from_middle, from_middle} + polar(radius, 0.5 * pi * i / steps);
            const Point turned = quarter * p;
            // Two quarter circles meet where no straight edge is left between them.
            if (ring.empty() || (abs(turned - ring.back()) > 1e-9 && abs(turned - ring.front()) > 1e-9))
                ring.push_back(turned);
        }
    }
    return ring;
}

std::vector<Point> leaf_outline(int steps) {
    // Half the width is sin(pi t) warped towards the stem; its largest value is scaled to 0.5.
    constexpr double warp = 0.8;
    const auto half_width = [](double t) { return 0.5 * std::pow(std::sin(pi * std::pow(t, warp)), 1.3); };
    std::vector<Point> ring;
    for (int i = 0; i < steps; ++i) {
        const double t = static_cast<double>(i) / steps;
        ring.push_back({t - 0.5, -half_width(t)});
    }
    for (int i = 0; i < steps; ++i) {
        const double t = 1 - static_cast<double>(i) / steps;
        ring.push_back({t - 0.5, half_width(t)});
    }
    return ring;
}

std::vector<Point> arrow_outline(double shaft, double head) {
    const double y = 0.5 * shaft, x = 0.5 - head;
    return {{-0.5, -y}, {x, -y}, {x, -0.5}, {0.5, 0}, {x, 0.5}, {x, y}, {-0.5, y}};
}

Region glyph_outline(int corners, int lines, double gap) {
    Region disc{round_outline(corners)};
    const double half = 0.5 * gap;
    if (lines >= 1) disc = difference_of(disc, {{{-1, -half}, {1, -half}, {1, half}, {-1, half}}});
    if (lines >= 2) disc = difference_of(disc, {{{-half, -1}, {half, -1}, {half, 1}, {-half, 1}}});
    return disc;
}

}  // namespace rinceau
