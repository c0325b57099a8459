#include "analyzer/gradient_difference.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rinceau {

namespace {

constexpr double levels = 255;
constexpr double unseen_change = 2 / levels;

/// How fast colour and opacity change along the gradient at most, in shares of their range per unit; infinite at an edge.
double steepest_change(const Gradient& gradient) {
    const auto change = [](const GradientStop& s, const GradientStop& t) {
        return std::max({std::abs(s.color.red - t.color.red) / levels, std::abs(s.color.green - t.color.green) / levels,
                         std::abs(s.color.blue - t.color.blue) / levels, std::abs(s.opacity - t.opacity)});
    };
    double steepest = 0;
    const std::vector<GradientStop>& stops = gradient.stops;
    for (std::size_t i = 1; i < stops.size(); ++i)
        if (const double step = change(stops[i - 1], stops[i]); step > 0)
            steepest = std::max(steepest, step / (stops[i].offset - stops[i - 1].offset));
    const bool jumps = gradient.spread == GradientSpread::repeat && change(stops.front(), stops.back()) > 0;
    return jumps ? std::numeric_limits<double>::infinity() : steepest;
}

/// Where along the gradient a point lies, in the frame of the unit gradient: the largest t whose circle, between the focal
/// one (t = 0) and the unit circle (t = 1), runs through it.
double radial_offset(const Gradient& gradient, Point p) {
    const Point from_focus = p - gradient.focus;
    const double r = gradient.focal_radius;
    const double a = dot(gradient.focus, gradient.focus) - (1 - r) * (1 - r);  // < 0: the focal circle lies inside
    const double b = -dot(from_focus, gradient.focus) - r * (1 - r);
    const double c = dot(from_focus, from_focus) - r * r;
    return (b - std::sqrt(std::max(0.0, b * b - a * c))) / a;
}

double offset_at(const Gradient& gradient, const Affine& to_unit, Point p) {
    const Point unit = apply(to_unit, p);
    return gradient.kind == GradientKind::linear ? unit.x : radial_offset(gradient, unit);
}

/// Largest change of offset for a step of length 1; for a focus aside an estimate from above.
double offset_per_length(const Gradient& gradient, const Affine& to_unit) {
    if (gradient.kind == GradientKind::linear) return std::hypot(to_unit.a, to_unit.c);
    const double stretch = std::hypot(to_unit.a, to_unit.b, std::hypot(to_unit.c, to_unit.d));
    return stretch / std::max(1 - abs(gradient.focus) - gradient.focal_radius, unseen_change);
}

}  // namespace

bool same_gradient_in(const Gradient& a, const Gradient& b, const Box& box, double distance) {
    const double a_size = determinant(a.map);
    const double b_size = determinant(b.map);
    if (a.kind != b.kind || a.spread != b.spread || a.stops != b.stops || a_size == 0 || b_size == 0) return a == b;
    const Affine to_a = inverse(a.map);
    const Affine to_b = inverse(b.map);
    const double by_color = unseen_change / steepest_change(a);  // infinite for one colour
    const double allowed = std::max(by_color, distance * std::min(offset_per_length(a, to_a), offset_per_length(b, to_b)));
    constexpr int steps = 4;  // a linear gradient shows at the corners; rings turn by little between such points
    for (int i = 0; i <= steps; ++i)
        for (int j = 0; j <= steps; ++j) {
            const Point p{std::lerp(box.low.x, box.high.x, static_cast<double>(i) / steps),
                          std::lerp(box.low.y, box.high.y, static_cast<double>(j) / steps)};
            if (std::abs(offset_at(a, to_a, p) - offset_at(b, to_b, p)) > allowed) return false;
        }
    return true;
}

}  // namespace rinceau
