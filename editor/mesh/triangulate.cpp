#include "editor/mesh/triangulate.h"

#include <algorithm>
#include <utility>

#include "editor/mesh/trapezoids.h"

namespace rinceau {
namespace {

/// The sweep is at its fastest, a corner, with about so many.
constexpr std::size_t swept_at_once = 500;

double median(const Contours& contours, Axis axis) {
    std::vector<double> values;
    values.reserve(corner_count(contours));
    for (const std::vector<Point>& contour : contours)
        for (const Point p : contour) values.push_back(along(axis, p));
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

/// Cut where the larger half is smaller.
CutContours halved(const Contours& contours) {
    const auto larger = [](const CutContours& halves) {
        return std::max(corner_count(halves.low), corner_count(halves.high));
    };
    CutContours by_x = cut(contours, Axis::x, median(contours, Axis::x));
    CutContours by_y = cut(contours, Axis::y, median(contours, Axis::y));
    return larger(by_x) < larger(by_y) ? std::move(by_x) : std::move(by_y);
}

void append(Triangles& triangles, const Triangles& more) {
    const auto first = static_cast<std::uint32_t>(triangles.points.size());
    triangles.points.insert(triangles.points.end(), more.points.begin(), more.points.end());
    for (const std::uint32_t index : more.indices) triangles.indices.push_back(first + index);
}

/// Outlines that cross themselves much: small parts as trapezoids.
void add_crossed(Triangles& triangles, const Contours& contours, FillRule rule, int cuts) {
    constexpr std::size_t few = 64;
    if (corner_count(contours) <= few || cuts == 0) {
        append(triangles, trapezoid_triangles(contours, rule));
        return;
    }
    const CutContours halves = halved(contours);
    add_crossed(triangles, halves.low, rule, cuts - 1);
    add_crossed(triangles, halves.high, rule, cuts - 1);
}

/// What is not to be cut further for the sweep.
void add_part(Triangles& triangles, const Contours& contours, FillRule rule) {
    constexpr std::size_t simple = 16;
    // More than these nobody sees apart, and drawing them takes long.
    constexpr double most_crossings = 50'000;
    constexpr double row_work = 2e7;
    constexpr int most_cuts = 12;
    const std::size_t count = corner_count(contours);
    const double crossings = count > simple ? crossing_count(contours) : 0;
    if (crossings > most_crossings) {
        const double rows = std::clamp(row_work / static_cast<double>(count), 64.0, 1024.0);
        append(triangles, row_triangles(contours, rule, static_cast<int>(rows)));
    } else if (crossings > 0.5 * static_cast<double>(count)) {
        add_crossed(triangles, contours, rule, most_cuts);
    } else {
        append(triangles, swept_triangles(contours, rule));
    }
}

void add_triangles(Triangles& triangles, const Contours& contours, FillRule rule) {
    const std::size_t count = corner_count(contours);
    if (count > swept_at_once) {
        const CutContours halves = halved(contours);
        // Where all edges meet, cutting does not help.
        constexpr double least_gain = 0.9;
        const auto enough = static_cast<std::size_t>(least_gain * static_cast<double>(count));
        if (corner_count(halves.low) < enough && corner_count(halves.high) < enough) {
            add_triangles(triangles, halves.low, rule);
            add_triangles(triangles, halves.high, rule);
            return;
        }
    }
    add_part(triangles, contours, rule);
}

}  // namespace

Triangles triangulated(const Contours& contours, FillRule rule) {
    Triangles triangles;
    add_triangles(triangles, contours, rule);
    return triangles;
}

}  // namespace rinceau
