#include "growth/arrangement/spray.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rinceau {
namespace {

Path path_of(const Polyline& line) {
    Path path{.start = line.front()};
    for (std::size_t i = 1; i < line.size(); ++i) path.segments.push_back(line_to(line[i]));
    return path;
}

}  // namespace

std::vector<Brush> brush_stops(const std::vector<Polyline>& path, double radius) {
    constexpr double stops_a_radius = 2;
    std::vector<Brush> stops;
    for (const Polyline& line : path) {
        const double count = std::max(std::ceil(stops_a_radius * length_of(line) / radius), 1.0);
        for (const Point at : cut_evenly(line, static_cast<std::size_t>(count))) stops.push_back({at, radius});
    }
    return stops;
}

Region sprayed_region(const std::vector<Polyline>& path, double radius) {
    constexpr double deviation = 1e-3;  // of the radius
    Element trail;
    for (const Polyline& line : path) trail.paths.push_back(path_of(line));
    trail.style.fill = NoPaint{};
    trail.style.stroke.paint = Color{};
    trail.style.stroke.width = 2 * radius;
    trail.style.stroke.cap = LineCap::round;
    trail.style.stroke.join = LineJoin::round;
    return painted_region(trail, deviation * radius);
}

ElementArrangement sprayed(ElementArrangement arrangement, const Exemplar& exemplar, const ArrangeSurroundings& around,
                           const std::vector<Brush>& stops, const GrowOrder& order, const Progress& progress) {
    for (std::size_t i = 0; i < stops.size(); ++i) {
        if (arrangement.elements >= order.count || (order.stop && order.stop())) break;
        report(progress, "spraying", static_cast<double>(i) / static_cast<double>(stops.size()));
        arrangement = with_seed(std::move(arrangement), exemplar, around, stops[i].center);
        GrowOrder here = order;
        here.brush = stops[i];
        arrangement = grow(std::move(arrangement), exemplar, around, here);
    }
    return arrangement;
}

}  // namespace rinceau
