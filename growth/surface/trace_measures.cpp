#include "growth/surface/trace_measures.h"

#include <algorithm>
#include <cmath>

#include "geometry/angle.h"
#include "geometry/index.h"

namespace rinceau {
namespace {

constexpr double least_piece = 1e-6;  // of the mean edge: the direction of shorter pieces is rounding

Complex in_frame(const SurfaceMesh& surface, int face, SpacePoint way) {
    return {dot(way, surface.frame[at(face)][0]), dot(way, surface.frame[at(face)][1])};
}

struct WalkMeasure {
    bool counts = true;
    long pieces = 0;
    double length = 0, sum = 0, largest = 0;
};

/// The angle between walk and field is that of the start up to a symmetry of the field.
WalkMeasure measure_walk(const FieldOnSurface& field, const SurfaceTrace& walk, Complex direction,
                         const std::vector<bool>& left_out) {
    const SurfaceMesh& surface = field.surface();
    const double symmetry = two_pi / field.n();
    const double kept = arg(direction) - arg(field.at(walk.path.front())) / field.n();
    WalkMeasure measure{!walk.at_border && walk.jumps == 0};
    for (std::size_t i = 0; i + 1 < walk.path.size() && measure.counts; ++i) {
        const SurfacePoint from = walk.path[i];
        measure.counts = !left_out[at(from.face)];
        // the next point lies on the far edge of this face or in it
        const SpacePoint way = position_in_space(surface, walk.path[i + 1]) - position_in_space(surface, from);
        measure.length += abs(way);
        if (abs(way) < least_piece * surface.mean_edge) continue;
        const Complex piece = in_frame(surface, from.face, way);
        const Complex value = field.at({from.face, from.at + piece / 2});
        const double error = std::abs(std::remainder(arg(piece) - arg(value) / field.n() - kept, symmetry));
        measure.sum += error * abs(way);
        measure.largest = std::max(measure.largest, error);
        ++measure.pieces;
    }
    return measure;
}

}  // namespace

std::vector<bool> near_singular_faces(const FieldOnSurface& field, int rings) {
    const SurfaceMesh& surface = field.surface();
    std::vector<bool> near(at(surface.faces()), false);
    for (const int face : field.singular_faces()) near[at(face)] = true;
    for (int ring = 0; ring < rings; ++ring) {
        std::vector<bool> vertices(at(surface.vertices()), false);
        for (int f = 0; f < surface.faces(); ++f)
            if (near[at(f)])
                for (const int v : surface.mesh.triangles[at(f)]) vertices[at(v)] = true;
        for (int f = 0; f < surface.faces(); ++f)
            for (const int v : surface.mesh.triangles[at(f)])
                if (vertices[at(v)]) near[at(f)] = true;
    }
    return near;
}

TraceMeasures measure_traces(const FieldOnSurface& field, const TraceMeasureOptions& options) {
    const SurfaceMesh& surface = field.surface();
    const std::vector<bool> left_out = near_singular_faces(field, options.rings);
    const double length = options.edges * surface.mean_edge;
    TraceOptions trace_options = options.trace;
    trace_options.keep_path = true;
    Random random(options.seed);
    TraceMeasures measures;
    double sum = 0, way = 0;
    for (int i = 0; i < options.walks; ++i) {
        const SurfacePoint start = random_surface_point(surface, random);
        const Complex direction = polar(1, random.uniform(-pi, pi));
        if (left_out[at(start.face)]) continue;
        const SurfaceTrace walk = trace(surface, &field, start, direction, length, trace_options);
        const WalkMeasure measure = measure_walk(field, walk, direction, left_out);
        if (!measure.counts) continue;
        ++measures.walks;
        measures.pieces += measure.pieces;
        measures.angle_max = std::max(measures.angle_max, measure.largest);
        measures.walks_above += measure.largest > radians(options.limit);
        measures.length_error = std::max(measures.length_error, std::abs(measure.length - length) / length);
        sum += measure.sum;
        way += measure.length;
    }
    measures.angle_mean = way > 0 ? sum / way : 0;
    return measures;
}

}  // namespace rinceau
