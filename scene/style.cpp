#include "scene/style.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rinceau {

namespace {

// Half a step of the 256 levels of a channel.
constexpr double share_tolerance = 1.0 / 512;
// Of a length that is far larger than the tolerance: it was turned and scaled there and back.
constexpr double rounding = 1e-12;

Linear2 product(const Linear2& m, const Linear2& n) {
    return {m.a * n.a + m.c * n.b, m.b * n.a + m.d * n.b, m.a * n.c + m.c * n.d, m.b * n.c + m.d * n.d};
}
Linear2 transposed(const Linear2& m) { return {m.a, m.c, m.b, m.d}; }

Paint transformed(const Paint& paint, const Similarity& map) {
    const auto* gradient = std::get_if<std::shared_ptr<const Gradient>>(&paint);
    if (!gradient) return paint;
    Gradient image = **gradient;
    image.map = to_affine(map) * image.map;
    return std::make_shared<const Gradient>(std::move(image));
}

bool near(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance; }
bool near(Point a, Point b, double tolerance) { return abs(a - b) <= tolerance; }

// Both maps lay the unit circle onto nearly the same ellipse: m m^T says which.
bool same_ellipse(const Linear2& m, const Linear2& n, double tolerance) {
    const Linear2 p = product(m, transposed(m));
    const Linear2 q = product(n, transposed(n));
    // Squares of lengths differ by twice the length times the difference.
    const double size = std::sqrt(std::max({p.a, p.d, q.a, q.d}));
    const double allowed = 2 * size * std::max(tolerance, rounding * size);
    return near(p.a, q.a, allowed) && near(p.b, q.b, allowed) && near(p.d, q.d, allowed);
}

bool same_stops(const std::vector<GradientStop>& a, const std::vector<GradientStop>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const GradientStop& s, const GradientStop& t) {
        return s.color == t.color && near(s.offset, t.offset, share_tolerance) &&
               near(s.opacity, t.opacity, share_tolerance);
    });
}

// Of all vectors that give the same linear gradient: from the point nearest the origin, across the lines of equal colour.
std::pair<Point, Point> canonical_vector(const Affine& map) {
    const double det = determinant(map);
    if (det == 0) return {{map.e, map.f}, {map.e + map.a, map.f + map.b}};
    const Point gradient{map.d / det, -map.c / det};
    const Point along = gradient / norm(gradient);
    const Point start = dot(gradient, {map.e, map.f}) * along;
    return {start, start + along};
}

bool same_linear(const Gradient& a, const Gradient& b, double tolerance) {
    const auto [a_start, a_end] = canonical_vector(a.map);
    const auto [b_start, b_end] = canonical_vector(b.map);
    return near(a_start, b_start, tolerance) && near(a_end, b_end, tolerance);
}

bool same_radial(const Gradient& a, const Gradient& b, double tolerance) {
    const Linear2 m{a.map.a, a.map.b, a.map.c, a.map.d};
    const Linear2 n{b.map.a, b.map.b, b.map.c, b.map.d};
    return near({a.map.e, a.map.f}, {b.map.e, b.map.f}, tolerance) && same_ellipse(m, n, tolerance) &&
           near(apply(a.map, a.focus), apply(b.map, b.focus), tolerance) &&
           near(a.focal_radius, b.focal_radius, share_tolerance);
}

bool same_gradient(const Gradient& a, const Gradient& b, double tolerance) {
    if (a.kind != b.kind || a.spread != b.spread || !same_stops(a.stops, b.stops)) return false;
    return a.kind == GradientKind::linear ? same_linear(a, b, tolerance) : same_radial(a, b, tolerance);
}

bool same_paint(const Paint& a, const Paint& b, double tolerance) {
    const auto* p = std::get_if<std::shared_ptr<const Gradient>>(&a);
    const auto* q = std::get_if<std::shared_ptr<const Gradient>>(&b);
    if (p && q) return *p == *q || same_gradient(**p, **q, tolerance);
    return a == b;
}

bool same_dashes(const Stroke& a, const Stroke& b, double tolerance) {
    if (a.dashes.empty() && b.dashes.empty()) return true;
    const auto same = [&](double s, double t) { return near(s, t, std::max(tolerance, rounding * std::abs(s))); };
    return same(a.dash_offset, b.dash_offset) &&
           std::equal(a.dashes.begin(), a.dashes.end(), b.dashes.begin(), b.dashes.end(), same);
}

bool same_outline_stroke(const Stroke& a, const Stroke& b, double tolerance) {
    const bool same_miter = a.join != LineJoin::miter || near(a.miter_limit, b.miter_limit, share_tolerance * a.miter_limit);
    return a.cap == b.cap && a.join == b.join && same_miter && same_paint(a.paint, b.paint, tolerance) &&
           same_pen(a, b, tolerance) && same_dashes(a, b, tolerance);
}

bool paints(const Paint& paint) { return !std::holds_alternative<NoPaint>(paint); }

}  // namespace

bool paints_fill(const Style& style) { return paints(style.fill) && style.fill_opacity > 0 && style.opacity > 0; }

bool paints_stroke(const Style& style) {
    const Stroke& stroke = style.stroke;
    return paints(stroke.paint) && stroke.width > 0 && stroke.opacity > 0 && style.opacity > 0;
}

Style transformed(const Style& style, const Similarity& map) {
    Style image = style;
    image.fill = transformed(style.fill, map);
    Stroke& stroke = image.stroke;
    stroke.paint = transformed(style.stroke.paint, map);
    if (stroke.fixed) return image;
    const double scale = scale_of(map);
    stroke.width *= scale;
    for (double& dash : stroke.dashes) dash *= scale;
    stroke.dash_offset *= scale;
    if (stroke.pen != Linear2{}) {
        // Turned on both sides, so that an even pen stays even and dashes, measured before the pen, keep their places.
        const Affine even = to_affine(map);
        const Linear2 turn{even.a / scale, even.b / scale, even.c / scale, even.d / scale};
        stroke.pen = product(product(turn, stroke.pen), transposed(turn));
    }
    return image;
}

bool same_style(const Style& a, const Style& b, double tolerance) {
    const bool fill = paints_fill(a);
    const bool stroke = paints_stroke(a);
    if (fill != paints_fill(b) || stroke != paints_stroke(b)) return false;
    if (!fill && !stroke) return true;
    if (a.crisp_edges != b.crisp_edges) return false;
    if (fill && (a.fill_rule != b.fill_rule || !same_paint(a.fill, b.fill, tolerance))) return false;
    if (stroke && !same_outline_stroke(a.stroke, b.stroke, tolerance)) return false;
    // With one of the two alone, only the product of its opacity and the common one shows.
    if (!stroke) return near(a.opacity * a.fill_opacity, b.opacity * b.fill_opacity, share_tolerance);
    if (!fill) return near(a.opacity * a.stroke.opacity, b.opacity * b.stroke.opacity, share_tolerance);
    return a.stroke_first == b.stroke_first && near(a.opacity, b.opacity, share_tolerance) &&
           near(a.fill_opacity, b.fill_opacity, share_tolerance) &&
           near(a.stroke.opacity, b.stroke.opacity, share_tolerance);
}

bool same_pen(const Stroke& a, const Stroke& b, double tolerance) {
    const auto scaled = [](const Linear2& m, double k) { return Linear2{k * m.a, k * m.b, k * m.c, k * m.d}; };
    return same_ellipse(scaled(a.pen, a.width), scaled(b.pen, b.width), tolerance);
}

}  // namespace rinceau
