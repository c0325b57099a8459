#include "analyzer/painted_form.h"

#include <algorithm>
#include <cmath>

namespace rinceau {

namespace {

/// Exact signed area under a cubic about the origin: half the integral of cross(B, B').
double area_under(Point a, const Segment& s) {
    if (s.straight) return cross(a, s.to) / 2;
    return (6 * cross(a, s.control1) + 3 * cross(a, s.control2) + cross(a, s.to) + 3 * cross(s.control1, s.control2) +
            3 * cross(s.control1, s.to) + 6 * cross(s.control2, s.to)) /
           20;
}

double signed_area(const Path& path) {
    const Point start = path.start;
    Point at = start;
    double area = 0;
    for (const Segment& s : path.segments) {
        area += area_under(at - start, {s.control1 - start, s.control2 - start, s.to - start, s.straight});
        at = s.to;
    }
    return area;
}

bool ends_at_start(const Path& path, double distance) {
    return !path.segments.empty() && abs(path.segments.back().to - path.start) <= distance;
}

PathStart start_of(const Path& path) {
    PathStart start{path.start, {}, path.closed};
    for (const Segment& s : path.segments)
        for (const Point p : {s.control1, s.control2, s.to})
            if (const double length = abs(p - path.start); length > 0) {
                start.direction = (p - path.start) / length;
                return start;
            }
    return start;
}

bool start_shows(const Element& element, double distance) {
    const Stroke& stroke = element.style.stroke;
    if (!stroke.dashes.empty()) return true;
    if (stroke.cap == LineCap::round && stroke.join == LineJoin::round) return false;
    return std::ranges::any_of(element.paths, [&](const Path& p) { return !p.closed && ends_at_start(p, distance); });
}

}  // namespace

PaintedForm painted_form(const Element& element, const Similarity& pose) {
    constexpr double coincident = 1e-6;  // of the unit: closer ends meet
    const double unit = scale_of(pose);
    PaintedForm form;
    if (paints_fill(element.style)) {
        double wound = 0;
        for (const Path& path : element.paths) {
            const double area = signed_area(path) / (unit * unit);
            form.covered_area += std::abs(area);
            wound += area;
        }
        if (element.style.fill_rule == FillRule::nonzero) form.wound_area = std::abs(wound);
    }
    if (!paints_stroke(element.style)) return form;
    form.sub_paths = static_cast<int>(element.paths.size());
    form.open_paths = static_cast<int>(std::ranges::count(element.paths, false, &Path::closed));
    if (!start_shows(element, coincident * unit)) {
        // An open sub-path whose round ends meet in a round joint looks closed.
        for (const Path& path : element.paths)
            if (!path.closed && ends_at_start(path, coincident * unit)) --form.open_paths;
        return form;
    }
    const Similarity to_unit = inverse(pose);
    for (const Path& path : element.paths) {
        PathStart start = start_of(path);
        start.at = apply(to_unit, start.at);
        start.direction = unit * (to_unit.linear * flipped_if(to_unit.mirrored, start.direction));
        form.starts.push_back(start);
    }
    return form;
}

bool same_starts(const PaintedForm& a, const Similarity& map, const PaintedForm& b, double distance) {
    constexpr double same_direction = 0.05;  // radians: directions only say which way a sub-path goes
    return std::ranges::equal(a.starts, b.starts, [&](const PathStart& s, const PathStart& t) {
        const Point direction = map.linear * flipped_if(map.mirrored, s.direction);
        return s.closed == t.closed && abs(apply(map, s.at) - t.at) <= distance &&
               abs(direction - t.direction) <= same_direction;
    });
}

bool same_form(const PaintedForm& a, const PaintedForm& b) {
    constexpr double same_area = 0.03;  // unit^2: outlines at the default tolerance differ by less
    return std::abs(a.covered_area - b.covered_area) <= same_area && std::abs(a.wound_area - b.wound_area) <= same_area &&
           a.sub_paths == b.sub_paths && a.open_paths == b.open_paths && a.starts.size() == b.starts.size();
}

}  // namespace rinceau
