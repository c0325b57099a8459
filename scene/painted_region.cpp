// Polygon clipping and offsetting by the library Clipper (A. Johnson, after B. Vatti, "A generic solution to polygon
// clipping", 1992), on an integer grid that is laid over each pair of regions.

#include "scene/painted_region.h"

#include <polyclipping/clipper.hpp>

#include <algorithm>
#include <cmath>

#include "scene/pen.h"

namespace rinceau {
namespace {

/// Coordinates up to this size stay within Clipper's fast 64-bit products.
constexpr double grid_extent = 5e8;

struct Grid {
    Point origin;
    double scale = 1;  ///< grid steps a px

    ClipperLib::IntPoint to_grid(Point p) const {
        const Point q = scale * (p - origin);
        return {static_cast<ClipperLib::cInt>(std::llround(q.x)), static_cast<ClipperLib::cInt>(std::llround(q.y))};
    }
    Point from_grid(const ClipperLib::IntPoint& p) const {
        return origin + Point{static_cast<double>(p.X), static_cast<double>(p.Y)} / scale;
    }
};

Grid grid_over(const Box& box) {
    if (is_empty(box)) return {};
    const double extent = std::max({width(box), height(box), 1e-300});
    return {center(box), grid_extent / extent};
}

ClipperLib::Path to_grid(const std::vector<Point>& polygon, const Grid& grid) {
    ClipperLib::Path path;
    path.reserve(polygon.size());
    for (const Point p : polygon) path.push_back(grid.to_grid(p));
    return path;
}

ClipperLib::Paths to_grid(const Region& region, const Grid& grid) {
    ClipperLib::Paths paths;
    paths.reserve(region.size());
    for (const auto& polygon : region) paths.push_back(to_grid(polygon, grid));
    return paths;
}

Region from_grid(const ClipperLib::Paths& paths, const Grid& grid) {
    Region region;
    region.reserve(paths.size());
    for (const ClipperLib::Path& path : paths) {
        std::vector<Point>& polygon = region.emplace_back();
        polygon.reserve(path.size());
        for (const ClipperLib::IntPoint& p : path) polygon.push_back(grid.from_grid(p));
    }
    return region;
}

Region combined(const Region& a, const Region& b, ClipperLib::ClipType operation) {
    const Grid grid = grid_over(including(bounds(a), bounds(b)));
    ClipperLib::Clipper clipper;
    clipper.AddPaths(to_grid(a, grid), ClipperLib::ptSubject, true);
    clipper.AddPaths(to_grid(b, grid), ClipperLib::ptClip, true);
    ClipperLib::Paths result;
    clipper.Execute(operation, result, ClipperLib::pftEvenOdd, ClipperLib::pftEvenOdd);
    return from_grid(result, grid);
}

/// Without crossings, outlines counter-clockwise and holes clockwise. (SimplifyPolygons compares all points of a polygon
/// with each other so that none touches itself; nothing here needs that.)
ClipperLib::Paths uncrossed(const ClipperLib::Paths& paths, ClipperLib::PolyFillType fill) {
    ClipperLib::Clipper clipper;
    clipper.AddPaths(paths, ClipperLib::ptSubject, true);
    ClipperLib::Paths result;
    clipper.Execute(ClipperLib::ctUnion, result, fill, fill);
    return result;
}

Region flattened_all(const std::vector<Path>& paths, double deviation) {
    Region polygons;
    polygons.reserve(paths.size());
    for (const Path& path : paths) polygons.push_back(flattened(path, deviation));
    return polygons;
}

ClipperLib::JoinType join_type(LineJoin join) {
    if (join == LineJoin::round) return ClipperLib::jtRound;
    // Clipper's square join holds every bevel.
    return join == LineJoin::miter ? ClipperLib::jtMiter : ClipperLib::jtSquare;
}

ClipperLib::EndType end_type(LineCap cap, bool dashed) {
    // A dash may end anywhere with its own cap, also beside the line's end.
    if (cap == LineCap::round || dashed) return ClipperLib::etOpenRound;
    return cap == LineCap::square ? ClipperLib::etOpenSquare : ClipperLib::etOpenButt;
}

Region stroke_region(const std::vector<Path>& paths, const Stroke& stroke, double deviation) {
    const bool even = stroke.pen == Linear2{};
    // A stretched pen is held by a round one; its mitres by one that is wider still.
    const double reach = even ? 1 : largest_stretch(stroke.pen) * (stroke.join == LineJoin::miter ? stroke.miter_limit : 1);
    const double half_width = 0.5 * stroke.width * reach;
    const Region lines = flattened_all(paths, deviation);
    // A pen wider than the paths must fit onto the grid too: mitres reach miter_limit half widths.
    const Grid grid = grid_over(grown(bounds(lines), half_width * std::max(stroke.miter_limit, 2.0)));
    ClipperLib::ClipperOffset offset(std::max(stroke.miter_limit, 2.0), std::max(1.0, deviation * grid.scale));
    for (std::size_t i = 0; i < paths.size(); ++i) {
        const auto open_end = even ? end_type(stroke.cap, !stroke.dashes.empty()) : ClipperLib::etOpenRound;
        const bool dot =
            lines[i].size() < 2 || std::ranges::all_of(lines[i], [&](Point p) { return p == lines[i].front(); });
        // a point has no join, but it is round or square by that
        const bool round = !even || (dot && open_end == ClipperLib::etOpenRound);
        const auto join = round ? ClipperLib::jtRound : join_type(stroke.join);
        ClipperLib::Path line = to_grid(lines[i], grid);
        // A single point has no join; doubled, it has caps.
        if (dot) line.push_back(line.front());
        offset.AddPath(line, join, paths[i].closed && !dot ? ClipperLib::etClosedLine : open_end);
    }
    ClipperLib::Paths result;
    offset.Execute(result, half_width * grid.scale);
    return from_grid(result, grid);
}

}  // namespace

Region enclosed_region(const std::vector<Path>& paths, FillRule rule, double deviation) {
    const Region outlines = flattened_all(paths, deviation);
    const Grid grid = grid_over(bounds(outlines));
    const auto fill = rule == FillRule::evenodd ? ClipperLib::pftEvenOdd : ClipperLib::pftNonZero;
    return from_grid(uncrossed(to_grid(outlines, grid), fill), grid);
}

Region painted_region(const Element& element, double deviation) {
    Region region;
    if (paints_fill(element.style)) region = enclosed_region(element.paths, element.style.fill_rule, deviation);
    if (!paints_stroke(element.style)) return region;
    const Region stroke = stroke_region(element.paths, element.style.stroke, deviation);
    return region.empty() ? stroke : union_of(region, stroke);
}

Region union_of(const Region& a, const Region& b) { return combined(a, b, ClipperLib::ctUnion); }
Region intersection_of(const Region& a, const Region& b) { return combined(a, b, ClipperLib::ctIntersection); }
Region difference_of(const Region& a, const Region& b) { return combined(a, b, ClipperLib::ctDifference); }

Region offset_region(const Region& region, double distance) {
    if (region.empty()) return {};
    const Grid grid = grid_over(grown(bounds(region), 2 * std::abs(distance)));
    ClipperLib::ClipperOffset offset;
    offset.AddPaths(uncrossed(to_grid(region, grid), ClipperLib::pftEvenOdd), ClipperLib::jtMiter,
                    ClipperLib::etClosedPolygon);
    ClipperLib::Paths result;
    offset.Execute(result, distance * grid.scale);
    return from_grid(result, grid);
}

double area(const Region& region) {
    const Grid grid = grid_over(bounds(region));
    double sum = 0;
    for (const ClipperLib::Path& path : uncrossed(to_grid(region, grid), ClipperLib::pftEvenOdd))
        sum += ClipperLib::Area(path);
    return sum / (grid.scale * grid.scale);
}

Box bounds(const Region& region) {
    Box box;
    for (const auto& polygon : region)
        for (const Point p : polygon) box = including(box, p);
    return box;
}

}  // namespace rinceau
