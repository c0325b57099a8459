#include "analyzer/style_axes.h"

#include <cmath>

#include "geometry/angle.h"

namespace rinceau {

namespace {

/// The long axis of the ellipse that a linear map lays the unit circle onto; nothing for a circle.
std::vector<double> long_axis(const Linear2& m, double tolerance) {
    // m m^T = ((p, q), (q, r))
    const double p = m.a * m.a + m.c * m.c;
    const double q = m.a * m.b + m.c * m.d;
    const double r = m.b * m.b + m.d * m.d;
    const double stretch = std::hypot(p - r, 2 * q);
    if (stretch <= 2 * tolerance * std::sqrt((p + r) / 2)) return {};
    const double angle = std::atan2(2 * q, p - r) / 2;
    return {angle, wrap_angle(angle + pi)};
}

std::vector<double> gradient_axes(const Gradient& gradient, double tolerance) {
    const Affine& m = gradient.map;
    if (gradient.kind == GradientKind::linear) {
        // Across the lines of equal colour: the gradient of the unit gradient's x.
        const double det = determinant(m);
        return {det == 0 ? arg({m.a, m.b}) : arg(Point{m.d, -m.c} / det)};
    }
    const Point center{m.e, m.f};
    if (abs(center) > tolerance) return {arg(center)};
    const Point focus = apply(m, gradient.focus) - center;
    if (abs(focus) > tolerance) return {arg(focus)};
    return long_axis({m.a, m.b, m.c, m.d}, tolerance);
}

std::vector<double> paint_axes(const Paint& paint, double tolerance) {
    const auto* gradient = std::get_if<std::shared_ptr<const Gradient>>(&paint);
    return gradient ? gradient_axes(**gradient, tolerance) : std::vector<double>{};
}

}  // namespace

std::vector<double> style_axes(const Style& style, double tolerance) {
    std::vector<double> axes;
    if (paints_fill(style)) axes = paint_axes(style.fill, tolerance);
    if (axes.empty() && paints_stroke(style)) axes = paint_axes(style.stroke.paint, tolerance);
    if (axes.empty() && paints_stroke(style)) axes = long_axis(style.stroke.pen, tolerance);
    return axes;
}

}  // namespace rinceau
