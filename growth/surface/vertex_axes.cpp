#include "growth/surface/vertex_axes.h"

#include <cmath>

#include "geometry/index.h"

namespace rinceau {
namespace {

/// Any direction at right angles to a normal.
SpacePoint any_tangent(SpacePoint normal) {
    constexpr double steep = 0.9;  // the x axis is then too near to the normal
    const SpacePoint away = std::abs(normal.x) < steep ? SpacePoint{1, 0, 0} : SpacePoint{0, 1, 0};
    return unit(away - dot(away, normal) * normal);
}

}  // namespace

SpacePoint vertex_axis(const SurfaceMesh& surface, int v) {
    const SpacePoint normal = surface.vertex_normal[at(v)], x = any_tangent(normal), y = cross(normal, x);
    Complex sum;  // of (way of an edge in x, y) over (its way in the vertex's frame)
    const auto add = [&](int other, double angle) {
        const SpacePoint edge = surface.mesh.positions[at(other)] - surface.mesh.positions[at(v)];
        const Complex seen{dot(edge, x), dot(edge, y)};
        if (const double length = abs(seen); length > 0) sum += seen / length * polar(1, -angle);
    };
    int h = surface.outgoing[at(v)];
    const int first = h;
    do {
        add(end_of(surface, h), surface.angle[at(h)]);
        const int before = previous_in_face(h);
        h = surface.twin[at(before)];
        if (h < 0) add(start_of(surface, before), surface.angle_back[at(before)]);
    } while (h >= 0 && h != first);
    constexpr double cancelled = 1e-9;
    const Complex turn = abs(sum) > cancelled ? sum / abs(sum) : Complex{1, 0};
    return turn.x * x + turn.y * y;
}

SpacePoint from_vertex_to_space(const SurfaceMesh& surface, SpacePoint axis, int v, Complex vector) {
    return vector.x * axis + vector.y * cross(surface.vertex_normal[at(v)], axis);
}

Complex from_space_to_vertex(const SurfaceMesh& surface, SpacePoint axis, int v, SpacePoint vector) {
    return {dot(vector, axis), dot(vector, cross(surface.vertex_normal[at(v)], axis))};
}

Complex corner_to_vertex(const SurfaceMesh& surface, int h) {
    const Complex along = edge_vector(surface, h);
    const double half = corner_angle(surface, h) / 2;
    const double scaled_half = surface.angle_scale[at(start_of(surface, h))] * half;
    return conj(along / abs(along) * polar(1, half)) * polar(1, surface.angle[at(h)] + scaled_half);
}

}  // namespace rinceau
