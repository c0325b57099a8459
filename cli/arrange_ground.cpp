#include "cli/arrange_ground.h"

#include <algorithm>
#include <cmath>

#include "cli/growth_input.h"
#include "files/files.h"
#include "growth/arrangement/spray.h"
#include "scene/input_error.h"

namespace rinceau {
namespace {

/// The picture of a guide; if it has no size of its own, what is drawn.
Box picture_of(const Scene& guide, const std::vector<Polyline>& lines) {
    if (guide.sized && width(guide.viewport) > 0 && height(guide.viewport) > 0) return guide.viewport;
    Box box;
    for (const Polyline& line : lines) {
        for (const Point p : line) box = including(box, p);
    }
    return box;
}

struct GuideLines {
    std::vector<Polyline> lines;
    Box picture;
};

GuideLines read_lines(const std::string& name, const std::string& what) {
    if (name.empty()) return {};
    const Scene guide = read_guide(name);
    GuideLines result{.lines = polylines_of(guide, guide_deviation(guide))};
    if (result.lines.empty())
        throw InputError({input_label(name)}, "expected " + what + ", found no line that has a length");
    result.picture = picture_of(guide, result.lines);
    return result;
}

/// Twice as wide and high as the exemplar, its upper left corner at the origin.
Box fourfold(const Box& exemplar_canvas) { return {{0, -2 * height(exemplar_canvas)}, {2 * width(exemplar_canvas), 0}}; }

/// Elements that reach into the picture may stand so far out.
double overhang(const Exemplar& exemplar) {
    double radius = 0;
    for (const ExemplarElement& element : exemplar.elements) radius = std::max(radius, element.radius);
    return exemplar.mean_edge + 2 * radius;
}

/// Where a count of elements will about come to stand.
Box reach_of(const ArrangeSettings& settings, const Exemplar& exemplar, const Box& ground) {
    if (!settings.count) return ground;
    constexpr double slack = 1.5;  // of the side of a square that holds them: growth is no square
    const double half = 0.5 * slack * std::sqrt(static_cast<double>(*settings.count) / exemplar.density);
    return including(ground, grown(Box{center(ground), center(ground)}, half));
}

}  // namespace

ArrangeGround read_arrange_ground(const ArrangeSettings& settings, const Exemplar& exemplar, const Box& exemplar_canvas) {
    ArrangeGround result;
    GuideLines boundary = read_lines(settings.boundary, "boundary lines");
    const GuideLines spray = read_lines(settings.spray, "lines for the brush to follow");
    const GuideLines flow = read_lines(settings.flow, "strokes that show the flow");

    // The canvas is the first that is told.
    Box picture = fourfold(exemplar_canvas);
    for (const Box& told : {flow.picture, boundary.picture, spray.picture}) {
        if (!is_empty(told)) picture = told;
    }
    if (settings.size) picture = {{0, -settings.size->y}, {settings.size->x, 0}};
    std::optional<Region> region;
    if (!settings.region.empty()) {
        const Scene guide = read_guide(settings.region);
        region = region_of(guide, guide_deviation(guide), input_label(settings.region));
        picture = picture_of(guide, *region);
        result.confined_by = input_label(settings.region);
    }
    result.stops = brush_stops(spray.lines, settings.spray_radius);
    const bool fills_canvas = !settings.count && !region && result.stops.empty();
    result.ground = region ? bounds(*region) : picture;
    if (fills_canvas) {
        // A brush over all of it, not a region: nothing is pushed about at the picture's edge, which cuts what lies across.
        result.ground = grown(picture, overhang(exemplar));
        result.limit = Brush{center(picture), 0.5 * diagonal(result.ground)};
    }
    if (!settings.count || settings.size) result.canvas = picture;
    if (result.confined_by.empty() && !settings.boundary.empty()) result.confined_by = input_label(settings.boundary);

    if (region || !boundary.lines.empty())
        result.around.boundary = std::make_shared<const Boundary>(std::move(boundary.lines), std::move(region));
    if (!flow.lines.empty()) {
        const Box box = grown(reach_of(settings, exemplar, result.ground), overhang(exemplar));
        const FlowOptions options{.step = 0.5 * exemplar.mean_edge, .directed = !settings.undirected};
        result.around.flow =
            std::make_shared<const FlowField>(make_flow_field(flow.lines, box, options, input_label(settings.flow)));
    }
    return result;
}

}  // namespace rinceau
