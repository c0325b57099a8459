// The union is taken square by square, each by a single call of Clipper (A. Johnson, after B. Vatti 1992): the union of many
// thousand outlines at once would take time that grows faster than their number.

#include "growth/measure/cover.h"

#include <polyclipping/clipper.hpp>

#include <algorithm>
#include <cmath>

#include "geometry/box_tree.h"
#include "growth/measure/outline_overlaps.h"

namespace rinceau {
namespace {

using ClipperLib::Paths;

constexpr double grid_extent = 2e9;  ///< half of it either way is just within Clipper's fast products
constexpr double regions_a_square = 40;

struct SceneGrid {
    Point origin;
    double scale = 1;

    Paths paths(const Region& region) const {
        Paths result;
        for (const auto& ring : region) {
            ClipperLib::Path& path = result.emplace_back();
            for (const Point p : ring) {
                const Point q = scale * (p - origin);
                path.emplace_back(static_cast<ClipperLib::cInt>(std::llround(q.x)),
                                  static_cast<ClipperLib::cInt>(std::llround(q.y)));
            }
        }
        // Even-odd becomes outer rings one way, holes the other, so that regions can be united by winding numbers.
        Paths oriented;
        ClipperLib::SimplifyPolygons(result, oriented, ClipperLib::pftEvenOdd);
        return oriented;
    }
};

double area_of(const Paths& paths) {
    double sum = 0;
    for (const ClipperLib::Path& path : paths) sum += ClipperLib::Area(path);
    return sum;
}

Region corners(const Box& box) { return {{box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}}}; }

Paths clipped(const std::vector<const Paths*>& subjects, const Paths& clip) {
    ClipperLib::Clipper clipper;
    for (const Paths* subject : subjects) clipper.AddPaths(*subject, ClipperLib::ptSubject, true);
    clipper.AddPaths(clip, ClipperLib::ptClip, true);
    Paths result;
    clipper.Execute(ClipperLib::ctIntersection, result, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
    return result;
}

struct Copies {
    std::vector<Region> regions;
    std::vector<std::size_t> firsts;  ///< one of each that was given
};

/// Regions, and on a tile their copies that reach into it from all sides.
Copies all_copies(const std::vector<Region>& regions, const PackDomain& domain) {
    Copies all;
    for (const Region& region : regions) {
        all.firsts.push_back(all.regions.size());
        if (!domain.tiled) {
            all.regions.push_back(region);
            continue;
        }
        const Box box = bounds(region);
        const Point size{width(domain.box), height(domain.box)};
        const auto tile_of = [&](Point p) {
            return Point{std::floor((p.x - domain.box.low.x) / size.x), std::floor((p.y - domain.box.low.y) / size.y)};
        };
        const Point low = tile_of(box.low), high = tile_of(box.high);
        for (double row = low.y; row <= high.y; ++row)
            for (double column = low.x; column <= high.x; ++column)
                all.regions.push_back(placed_region(region, translate({-column * size.x, -row * size.y})));
    }
    return all;
}

}  // namespace

Cover cover(const std::vector<Region>& regions, const PackDomain& domain) {
    const Copies copies = all_copies(regions, domain);
    std::vector<Box> boxes;
    Box everything = domain.box;
    for (const Region& region : copies.regions) {
        boxes.push_back(bounds(region));
        everything = including(everything, boxes.back());
    }
    // On a tile only what lies in it counts: the copies hold the rest.
    const Box ground = domain.tiled ? domain.box : everything;
    const SceneGrid grid{center(everything), grid_extent / std::max(width(everything), height(everything))};
    const double unit = 1 / (grid.scale * grid.scale);

    std::vector<Paths> paths;
    paths.reserve(copies.regions.size());
    for (const Region& region : copies.regions) paths.push_back(grid.paths(region));
    const Paths inside = grid.paths(domain.region ? *domain.region : corners(domain.box));
    Cover cover;
    cover.domain = unit * area_of(inside);
    for (const std::size_t first : copies.firsts) cover.sum += unit * area_of(paths[first]);

    const BoxTree tree(boxes);
    const int squares = std::max(1, static_cast<int>(std::sqrt(static_cast<double>(regions.size()) / regions_a_square)));
    for (int row = 0; row < squares; ++row)
        for (int column = 0; column < squares; ++column) {
            const auto corner = [&](int c, int r) {
                return ground.low + Point{width(ground) * c / squares, height(ground) * r / squares};
            };
            const Box square{corner(column, row), corner(column + 1, row + 1)};
            std::vector<const Paths*> found;
            tree.visit(square, [&](std::size_t i) {
                found.push_back(&paths[i]);
                return true;
            });
            if (found.empty()) continue;
            const Paths united = clipped(found, grid.paths(corners(square)));
            cover.united += unit * area_of(united);
            cover.within += unit * area_of(clipped({&united}, inside));
        }
    return cover;
}

}  // namespace rinceau
