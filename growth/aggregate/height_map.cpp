// Sakurai & Miyata 2014, figure 16: height maps of leather, cristae with sulci between them. The paper lays grey pictures of
// cristae; here heights follow from the outlines: a crista rises with the distance from its edge (smooth_distance.h), a
// sulcus falls with the distance from the nearest one.

#include "growth/aggregate/height_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "growth/aggregate/smooth_distance.h"
#include "scene/input_error.h"

namespace rinceau {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Values at the middle of the pixels of a box.
struct PixelField {
    int columns = 0, rows = 0;
    double step = 1;
    Box box;
    std::vector<double> values;

    std::size_t at(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
    }
    double x(int column) const { return box.low.x + (column + 0.5) * width(box) / columns; }
    double y(int row) const { return box.high.y - (row + 0.5) * height(box) / rows; }
};

PixelField make_field(const Box& box, int columns, double value) {
    constexpr double most_pixels = 64e6;
    const double rows = std::max(1.0, std::round(columns * height(box) / width(box)));
    if (rows * columns > most_pixels)
        throw LimitError({}, "the height map has more than 64 million pixels; make it smaller");
    PixelField field{columns, static_cast<int>(rows), width(box) / columns, box, {}};
    field.values.assign(static_cast<std::size_t>(columns) * static_cast<std::size_t>(field.rows), value);
    return field;
}

Region placed_region(const Region& region, const Similarity& pose, Point shift) {
    Region placed = region;
    for (std::vector<Point>& ring : placed)
        for (Point& p : ring) p = apply(pose, p) + shift;
    return placed;
}

/// Where a row of pixels lies inside: the even-odd rule.
std::vector<double> crossings_of_row(const Region& region, double y) {
    std::vector<double> at;
    for (const std::vector<Point>& ring : region)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point a = ring[i], b = ring[(i + 1) % ring.size()];
            if ((a.y <= y) == (b.y <= y)) continue;
            at.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
        }
    std::ranges::sort(at);
    return at;
}

/// What a shape does to the pixels within `reach` of it: `visit(index, p, inside)`.
template <class Visit>
void for_each_pixel(const PixelField& field, const Region& region, double reach, const Visit& visit) {
    const Box box = grown(bounds(region), reach);
    const double per_x = field.columns / width(field.box), per_y = field.rows / height(field.box);
    const auto pixel = [](double value, int count) { return static_cast<int>(std::clamp(value, 0.0, double(count))); };
    const int left = pixel(std::floor((box.low.x - field.box.low.x) * per_x), field.columns);
    const int right = pixel(std::ceil((box.high.x - field.box.low.x) * per_x), field.columns);
    const int top = pixel(std::floor((field.box.high.y - box.high.y) * per_y), field.rows);
    const int bottom = pixel(std::ceil((field.box.high.y - box.low.y) * per_y), field.rows);
    for (int row = top; row < bottom; ++row) {
        const std::vector<double> crossings = crossings_of_row(region, field.y(row));
        std::size_t passed = 0;
        for (int column = left; column < right; ++column) {
            const Point p{field.x(column), field.y(row)};
            while (passed < crossings.size() && crossings[passed] <= p.x) ++passed;
            visit(field.at(column, row), p, passed % 2 == 1);
        }
    }
}

/// Calls `visit(region)` with each placed shape; in a tile also with its copies beyond the border that reach into the box.
template <class Visit>
void for_each_placed(const std::vector<Region>& shapes, const std::vector<PlacedRegion>& placed, const PackDomain& domain,
                     double reach, const Progress& progress, const Visit& visit) {
    const int beyond = domain.tiled ? 1 : 0;
    for (std::size_t i = 0; i < placed.size(); ++i) {
        report(progress, "height map", static_cast<double>(i) / static_cast<double>(placed.size()));
        for (int across = -beyond; across <= beyond; ++across)
            for (int up = -beyond; up <= beyond; ++up) {
                const Region region = placed_region(shapes[static_cast<std::size_t>(placed[i].shape)], placed[i].pose,
                                                    {across * width(domain.box), up * height(domain.box)});
                if (overlap(grown(bounds(region), reach), domain.box)) visit(region);
            }
    }
}

std::vector<Region> all_oriented(const std::vector<Region>& shapes) {
    std::vector<Region> result;
    for (const Region& shape : shapes) result.push_back(oriented(shape));
    return result;
}

double smooth_step(double t) {
    const double s = std::clamp(t, 0.0, 1.0);
    return s * s * (3 - 2 * s);
}

/// From 0 at the edge (t = 0) to 1.
double profile_at(CristaProfile profile, double t) {
    const double s = std::clamp(t, 0.0, 1.0);
    constexpr double rounded = 0.35;  // share of the way that a plateau's edge takes
    switch (profile) {
        case CristaProfile::dome:
            return std::sqrt(s * (2 - s));
        case CristaProfile::plateau:
            return std::sqrt(std::min(1.0, s / rounded) * (2 - std::min(1.0, s / rounded)));
        case CristaProfile::cone:
            return s;
    }
    return s;
}

}  // namespace

HeightMap height_map(const std::vector<Region>& cristae, const std::vector<Region>& sulci,
                     const std::vector<PlacedRegion>& placed, const PackDomain& domain, const HeightMapOptions& options,
                     const Progress& progress) {
    // How far inside a crista each pixel lies.
    PixelField inside = make_field(domain.box, options.columns, 0);
    const std::vector<Region> ridges = all_oriented(cristae);
    for_each_placed(ridges, placed, domain, 0, progress, [&](const Region& region) {
        for_each_pixel(inside, region, 0, [&](std::size_t i, Point p, bool is_inside) {
            if (is_inside) inside.values[i] = std::max(inside.values[i], smooth_inside_distance(region, p));
        });
    });
    const double rise = std::max(*std::ranges::max_element(inside.values), inside.step);

    // How far outside of all.
    const double reach = options.sulcus_width > 0 ? options.sulcus_width : rise / 2;
    PixelField outside = make_field(domain.box, options.columns, infinite);
    for_each_placed(ridges, placed, domain, reach, progress, [&](const Region& region) {
        for_each_pixel(outside, region, reach, [&](std::size_t i, Point p, bool) {
            if (inside.values[i] == 0 && outside.values[i] > 0)
                outside.values[i] = std::min(outside.values[i], outline_distance_at(region, p));
        });
    });

    HeightMap map{inside.columns, inside.rows, {}, domain.box, rise};
    map.heights.reserve(inside.values.size());
    for (std::size_t i = 0; i < inside.values.size(); ++i) {
        const double t = inside.values[i] / rise;
        map.heights.push_back(t > 0 ? options.depth + (1 - options.depth) * profile_at(options.profile, t)
                                    : options.depth * (1 - smooth_step(outside.values[i] / reach)));
    }

    if (sulci.empty()) return map;
    // Sulci of their own, sunk in from their edges.
    for_each_placed(all_oriented(sulci), placed, domain, 0, progress, [&](const Region& region) {
        for_each_pixel(inside, region, 0, [&](std::size_t i, Point p, bool is_inside) {
            if (!is_inside) return;
            const double sunk = options.depth * smooth_step(smooth_inside_distance(region, p) / (rise / 2));
            map.heights[i] = std::max(0.0, map.heights[i] - sunk);
        });
    });
    return map;
}

}  // namespace rinceau
