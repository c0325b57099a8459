// Li et al. 2010, section 4.3.1. Charts are an addition: a ring of places walked to one by one does not close on a curved
// surface, one laid through a geodesic polar map does.
#include "growth/surface/shape_moves.h"

#include <algorithm>
#include <cmath>

namespace rinceau {

namespace {

constexpr double chart_reserve = 1.25;  // a chart reaches this much farther than it was asked to
constexpr double chart_most = 4;        // diagonals: no way on a surface with fewer folds than a brain is longer
constexpr double chart_step = 0.25;     // of the mean edge, between points of a way through a chart

/// The walk of the scope's point in the chart, from the chart's origin.
bool reaches(const SurfaceMesh& surface, ScopeChart& chart, double distance) {
    while (!chart.complete && (!chart.lookup || chart.chart.radius < distance)) {
        const double radius = std::max({chart_reserve * distance, 2 * chart.chart.radius, 2 * surface.mean_edge});
        chart.lookup.reset();
        chart.chart = surface_chart(surface, chart.anchor, chart.x, radius);
        chart.lookup.emplace(surface, chart.chart);
        chart.complete =
            radius > chart_most * surface.diagonal || chart.chart.triangles.size() == surface.mesh.triangles.size();
    }
    return chart.lookup.has_value();
}

/// Nothing where the chart does not lie.
std::optional<ScopeWalk> walk_in_chart(const SurfaceMesh& surface, ShapeScope& scope, Complex way, bool keep_path) {
    const Complex from = scope.chart_place, to = from + scope.chart_x * way;
    if (!reaches(surface, *scope.chart, std::max(abs(from), abs(to)))) return std::nullopt;
    const std::optional<ChartPlace> end = scope.chart->lookup->find(to);
    if (!end) return std::nullopt;
    ScopeWalk result{false, abs(way), {}};
    if (keep_path) {
        result.path.push_back(scope.at);
        const int pieces = static_cast<int>(std::ceil(abs(way) / (chart_step * surface.mean_edge)));
        for (int i = 1; i < pieces; ++i) {
            const double share = static_cast<double>(i) / pieces;
            if (const auto place = scope.chart->lookup->find((1 - share) * from + share * to))
                result.path.push_back(place->at);
        }
        result.path.push_back(end->at);
    }
    scope.chart_place = to;
    scope.at = end->at;
    scope.x = end->x * scope.chart_x;
    scope.x = scope.x / abs(scope.x);
    return result;
}

}  // namespace

ScopeWalk walk(const MoveGround& ground, ShapeScope& scope, Complex way, bool straight, bool keep_path,
               PatternCounts& counts) {
    const double length = abs(way);
    if (length == 0) return {};
    ++counts.translations;
    if (scope.chart) {
        if (auto walked = walk_in_chart(*ground.surface, scope, way, keep_path)) return *std::move(walked);
        scope.chart.reset();
    }
    TraceOptions options = ground.trace;
    options.keep_path = keep_path;
    const Complex turn = way / length;
    const FieldOnSurface* field = straight ? nullptr : ground.follow;
    SurfaceTrace trace = rinceau::trace(*ground.surface, field, scope.at, scope.x * turn, length, options);
    scope.at = trace.end;
    scope.x = conj(turn) * trace.direction;
    scope.x = scope.x / abs(scope.x);
    counts.jumps += trace.jumps;
    counts.angle_error_max = std::max(counts.angle_error_max, trace.angle_error);
    counts.angle_error_sum += trace.angle_error_sum;
    counts.angle_samples += trace.angle_samples;
    return {trace.at_border, trace.length, std::move(trace.path)};
}

void begin_chart(ShapeScope& scope) {
    scope.chart = std::make_shared<ScopeChart>();
    scope.chart->anchor = scope.at;
    scope.chart->x = scope.x;
    scope.chart_place = {0, 0};
    scope.chart_x = {1, 0};
}

}  // namespace rinceau
