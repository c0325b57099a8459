// Fills and strokes as regions (scene/painted_region.h), regions as triangles. A stroke is laid above its whole fill and not
// beside it, so that no hairline shows between them.

#include "growth/surface/terminal_art.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "growth/mesh/region_triangles.h"
#include "growth/surface/dash_lines.h"
#include "lsystem/drawn_style.h"

namespace rinceau {
namespace {

constexpr double opaque = 0.999;  // below half a step of 255
constexpr double unseen = 0.004;  // opacity of one step of 255

std::uint8_t channel(double value) { return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0))); }

Color mixed(Color color, double share, Color ground) {
    const auto mix = [share](std::uint8_t a, std::uint8_t b) { return channel(share * a + (1 - share) * b); };
    return {mix(color.red, ground.red), mix(color.green, ground.green), mix(color.blue, ground.blue)};
}

double mean_opacity(const Gradient& gradient) {
    double sum = 0, before = 0;
    const GradientStop* last = &gradient.stops.front();
    for (const GradientStop& stop : gradient.stops) {
        sum += 0.5 * (stop.offset - before) * (last->opacity + stop.opacity);
        before = stop.offset;
        last = &stop;
    }
    return sum + (1 - before) * last->opacity;
}

/// A paint as one colour, with what remains of its opacity.
struct FlatPaint {
    Color color;
    double opacity = 0;
    bool gradient = false;
};

FlatPaint flat_paint(const Paint& paint, double opacity) {
    if (const Color* color = std::get_if<Color>(&paint)) return {*color, opacity, false};
    if (const auto* gradient = std::get_if<std::shared_ptr<const Gradient>>(&paint))
        return {mean_color(**gradient), opacity * mean_opacity(**gradient), true};
    return {};
}

ArtLayer layer_of(const Region& region, const FlatPaint& paint, int level) {
    ArtLayer layer;
    layer.opacity = paint.opacity;
    layer.color = paint.opacity < opaque ? mixed(paint.color, paint.opacity, ground_color) : paint.color;
    layer.level = level;
    RegionTriangles cut = region_triangles(region);
    layer.points = std::move(cut.points);
    layer.triangles = std::move(cut.triangles);
    layer.borders = std::move(cut.borders);
    for (const auto& [a, b, c] : layer.triangles) {
        const auto point = [&](int i) { return layer.points[static_cast<std::size_t>(i)]; };
        layer.area += 0.5 * cross(point(b) - point(a), point(c) - point(a));
    }
    return layer;
}

/// Andrew's monotone chain.
std::vector<Point> hull_of(std::vector<Point> points) {
    std::ranges::sort(points, [](Point a, Point b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    std::vector<Point> hull;
    const auto add_chain = [&](auto first, auto last) {
        const std::size_t start = hull.size();
        for (auto p = first; p != last; ++p) {
            while (hull.size() >= start + 2 && cross(hull.back() - hull[hull.size() - 2], *p - hull.back()) <= 0)
                hull.pop_back();
            hull.push_back(*p);
        }
        hull.pop_back();
    };
    if (points.size() < 3) return points;
    add_chain(points.begin(), points.end());
    add_chain(points.rbegin(), points.rend());
    return hull;
}

int packed(const std::optional<Color>& color) { return color ? (color->red << 16) + (color->green << 8) + color->blue : -1; }

}  // namespace

Color mean_color(const Gradient& gradient) {
    double red = 0, green = 0, blue = 0, weight = 0, before = 0;
    const GradientStop* last = &gradient.stops.front();
    const auto add = [&](const GradientStop& stop, double share) {
        red += share * stop.color.red;
        green += share * stop.color.green;
        blue += share * stop.color.blue;
        weight += share;
    };
    for (const GradientStop& stop : gradient.stops) {
        const double half = 0.5 * (stop.offset - before);
        add(*last, half * last->opacity);
        add(stop, half * stop.opacity);
        before = stop.offset;
        last = &stop;
    }
    add(*last, (1 - before) * last->opacity);
    if (!(weight > 0)) return last->color;
    return {channel(red / weight), channel(green / weight), channel(blue / weight)};
}

ArtStore::ArtStore(const Grammar& grammar, double deviation, double finest)
    : grammar_(&grammar), styles_(grammar), deviation_(deviation), finest_(finest) {}

ArtStore::Known ArtStore::made(const Placement& placement, double scale) const {
    Known known;
    const Terminal& terminal = grammar_->terminals[static_cast<std::size_t>(placement.terminal)];
    Style style = repainted(styles_.style(drawn_style_number(*grammar_, placement)), placement.repaint);
    if (style.stroke.fixed) {  // a length of the drawing, here in the terminal's frame
        style.stroke.width /= scale;
        for (double& dash : style.stroke.dashes) dash /= scale;
        style.stroke.dash_offset /= scale;
    }
    const double radius = 0.5 * diagonal(bounds(terminal.paths)) + style.stroke.width;
    const double deviation = std::max(deviation_ * radius, finest_ / scale);
    const FlatPaint fill = flat_paint(style.fill, style.opacity * style.fill_opacity);
    const FlatPaint stroke = flat_paint(style.stroke.paint, style.opacity * style.stroke.opacity);
    const auto add = [&](const Region& region, const FlatPaint& paint, int level) {
        if (region.empty()) return;
        known.art.layers.push_back(layer_of(region, paint, level));
        known.gradient |= paint.gradient;
        known.translucent |= paint.opacity < opaque;
    };
    if (paints_fill(style) && fill.opacity > unseen)
        add(enclosed_region(terminal.paths, style.fill_rule, deviation), fill, style.stroke_first ? 1 : 0);
    if (paints_stroke(style) && stroke.opacity > unseen) {
        Element line{dash_lines(terminal.paths, style.stroke, deviation), style, {}, {}, {}};
        line.style.fill = NoPaint{};
        line.style.stroke.dashes.clear();
        add(painted_region(line, deviation), stroke, style.stroke_first ? 0 : 1);
    }
    if (known.art.layers.size() == 1) known.art.layers[0].level = 0;
    std::vector<Point> points;
    for (const ArtLayer& layer : known.art.layers) points.insert(points.end(), layer.points.begin(), layer.points.end());
    for (const Point p : points) known.art.box = including(known.art.box, p);
    known.art.hull = hull_of(std::move(points));
    std::erase_if(known.art.layers, [](const ArtLayer& layer) { return !(layer.area > 0); });
    return known;
}

const TerminalArt& ArtStore::art(const Placement& placement) {
    static const TerminalArt nothing;
    if (!grammar_->terminals[static_cast<std::size_t>(placement.terminal)].verbatim.empty()) {
        ++losses_.verbatim;
        return nothing;
    }
    const double scale = scale_of(placement.pose);
    int octave = 0;
    std::frexp(scale, &octave);
    const Stroke& stroke = styles_.style(drawn_style_number(*grammar_, placement)).stroke;
    const bool fixed = stroke.fixed;
    const Key key{placement.terminal,
                  drawn_style_number(*grammar_, placement),
                  {packed(placement.repaint.fill), packed(placement.repaint.stroke)},
                  octave,
                  fixed ? scale : 0};
    std::unique_ptr<Known>& known = known_[key];
    // of one octave all have the triangles of its largest
    if (!known) known = std::make_unique<Known>(made(placement, fixed ? scale : std::ldexp(1.0, octave)));
    losses_.gradients += known->gradient;
    losses_.translucent += known->translucent;
    losses_.empty += known->art.layers.empty();
    return known->art;
}

}  // namespace rinceau
