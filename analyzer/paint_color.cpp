#include "analyzer/paint_color.h"

#include <optional>

namespace rinceau {
namespace {

Ink ink_of(const Color& color, double alpha) {
    constexpr double full = 255;
    return alpha * Ink{color.red / full, color.green / full, color.blue / full, 1};
}

/// The share 0..1 of the way along the stops that a parameter falls on.
double spread_offset(GradientSpread spread, double t) {
    if (spread == GradientSpread::pad) return std::clamp(t, 0.0, 1.0);
    if (spread == GradientSpread::repeat) return t - std::floor(t);
    const double in_two = t - 2 * std::floor(t / 2);
    return in_two > 1 ? 2 - in_two : in_two;
}

Ink stop_ink(const GradientStop& stop) { return ink_of(stop.color, stop.opacity); }

Ink color_at_offset(const Gradient& gradient, double offset) {
    const std::vector<GradientStop>& stops = gradient.stops;
    std::size_t next = 0;
    while (next < stops.size() && stops[next].offset <= offset) ++next;
    if (next == 0) return stop_ink(stops.front());
    if (next == stops.size()) return stop_ink(stops.back());
    const double gap = stops[next].offset - stops[next - 1].offset;
    const double share = (offset - stops[next - 1].offset) / gap;
    return (1 - share) * stop_ink(stops[next - 1]) + share * stop_ink(stops[next]);
}

/// The largest t whose circle - centre focus - t focus, radius focal_radius + t (1 - focal_radius) >= 0 - passes through p.
std::optional<double> radial_parameter(const Gradient& gradient, Point p) {
    const double growth = 1 - gradient.focal_radius;
    const Point from_focus = p - gradient.focus;
    const double a = norm(gradient.focus) - growth * growth;
    const double b = dot(from_focus, -gradient.focus) + gradient.focal_radius * growth;
    const double c = norm(from_focus) - gradient.focal_radius * gradient.focal_radius;
    const auto painted = [&](double t) { return gradient.focal_radius + t * growth >= 0; };
    if (a == 0) return b != 0 && painted(c / (2 * b)) ? std::optional(c / (2 * b)) : std::nullopt;
    const double square = b * b - a * c;
    if (square < 0) return std::nullopt;
    const double one = (b + std::sqrt(square)) / a;
    const double other = (b - std::sqrt(square)) / a;
    if (painted(std::max(one, other))) return std::max(one, other);
    return painted(std::min(one, other)) ? std::optional(std::min(one, other)) : std::nullopt;
}

}  // namespace

PaintSampler paint_sampler(const Paint& paint, double opacity) {
    PaintSampler sampler{.opacity = opacity};
    if (const Color* color = std::get_if<Color>(&paint)) {
        sampler.solid = ink_of(*color, opacity);
    } else if (const auto* shared = std::get_if<std::shared_ptr<const Gradient>>(&paint)) {
        const Gradient& gradient = **shared;
        if (determinant(gradient.map) == 0) {
            sampler.solid = opacity * stop_ink(gradient.stops.back());  // as SVG has it for a gradient without extent
        } else {
            sampler.gradient = &gradient;
            sampler.to_unit = inverse(gradient.map);
        }
    }
    return sampler;
}

Ink paint_at(const PaintSampler& sampler, Point p) {
    if (sampler.gradient == nullptr) return sampler.solid;
    const Gradient& gradient = *sampler.gradient;
    const Point unit = apply(sampler.to_unit, p);
    const std::optional<double> t =
        gradient.kind == GradientKind::linear ? std::optional(unit.x) : radial_parameter(gradient, unit);
    return t ? sampler.opacity * color_at_offset(gradient, spread_offset(gradient.spread, *t)) : Ink{};
}

}  // namespace rinceau
