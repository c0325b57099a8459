#include "scene/svg_arc.h"

#include <algorithm>
#include <cmath>

#include "geometry/angle.h"

namespace rinceau {

namespace {

// A quarter that rounding has made a little longer still is one quarter.
constexpr double quarter_slack = 1e-9;

// The arc's ellipse as the unit circle's image, and the angles on that circle. (F.6.5, F.6.6)
struct CenterForm {
    Affine to_ellipse;
    double start = 0;
    double sweep = 0;
};

CenterForm center_form(Point from, Point radii, double rotation, bool large, bool sweep, Point to) {
    const Complex turn = polar(1, rotation);
    // Half the chord in the ellipse's own axes, in units of the radii.
    const Point half = conj(turn) * (0.5 * (from - to));
    Point unit{half.x / radii.x, half.y / radii.y};
    const double squared = norm(unit);
    if (squared > 1) {
        radii = std::sqrt(squared) * radii;
        unit = unit / std::sqrt(squared);
    }
    // The centre lies on the chord's perpendicular at the distance that makes the radius 1.
    const double away = std::sqrt(std::max(0.0, 1 - norm(unit)) / norm(unit)) * (large == sweep ? -1 : 1);
    const Point center_unit{away * unit.y, -away * unit.x};
    const double start = arg(unit - center_unit);
    double angle = arg(-unit - center_unit) - start;
    if (sweep && angle < 0) angle += two_pi;
    if (!sweep && angle > 0) angle -= two_pi;
    const Point center = turn * Point{center_unit.x * radii.x, center_unit.y * radii.y} + 0.5 * (from + to);
    const Affine to_ellipse{turn.x * radii.x, turn.y * radii.x, -turn.y * radii.y, turn.x * radii.y, center.x, center.y};
    return {to_ellipse, start, angle};
}

}  // namespace

double arc_handle(double angle) { return 4.0 / 3 * std::tan(angle / 4); }

std::vector<Segment> arc_segments(Point from, Point radii, double rotation, bool large, bool sweep, Point to) {
    radii = {std::abs(radii.x), std::abs(radii.y)};
    if (from == to || !(radii.x > 0 && radii.y > 0)) return {line_to(to)};
    const CenterForm arc = center_form(from, radii, rotation, large, sweep, to);
    if (!std::isfinite(arc.sweep)) return {line_to(to)};  // chord and radii are too unlike for their squares
    const int count = std::max(1, static_cast<int>(std::ceil(std::abs(arc.sweep) / (pi / 2) - quarter_slack)));
    const double step = arc.sweep / count;
    const double handle = arc_handle(step);
    std::vector<Segment> segments;
    for (int i = 0; i < count; ++i) {
        const Point begin = polar(1, arc.start + i * step);
        const Point end = polar(1, arc.start + (i + 1) * step);
        const Point control1 = apply(arc.to_ellipse, begin + handle * Point{-begin.y, begin.x});
        const Point control2 = apply(arc.to_ellipse, end - handle * Point{-end.y, end.x});
        segments.push_back(curve_to(control1, control2, i + 1 == count ? to : apply(arc.to_ellipse, end)));
    }
    return segments;
}

}  // namespace rinceau
