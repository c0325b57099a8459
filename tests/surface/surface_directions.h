#pragma once
// Fields from directions in space, for tests.

#include <functional>

#include "geometry/angle.h"
#include "growth/surface/surface_field.h"

namespace rinceau {

/// A direction in space as an angle of the vertex's frame: between the projected edges beside it, in proportion.
inline double angle_in_vertex_frame(const SurfaceMesh& surface, int v, SpacePoint direction, SpacePoint normal) {
    const SpacePoint origin = surface.mesh.positions[static_cast<std::size_t>(v)];
    const auto angle_to = [&](int h, bool end) {
        const int other = end ? end_of(surface, h) : start_of(surface, previous_in_face(h));
        const SpacePoint edge = surface.mesh.positions[static_cast<std::size_t>(other)] - origin;
        const SpacePoint flat = edge - dot(edge, normal) * normal;
        return std::atan2(dot(cross(flat, direction), normal), dot(flat, direction));
    };
    int h = surface.outgoing[static_cast<std::size_t>(v)];
    const int first = h;
    do {
        const double from = angle_to(h, true), to = angle_to(h, false);
        if (from >= 0 && to <= 0 && from - to < pi) {
            const double scale = surface.angle_scale[static_cast<std::size_t>(v)];
            const double share = from - to > 0 ? from / (from - to) : 0;
            return surface.angle[static_cast<std::size_t>(h)] + share * scale * corner_angle(surface, h);
        }
        h = next_about_start(surface, h);
    } while (h >= 0 && h != first);
    return surface.angle[static_cast<std::size_t>(first)] + angle_to(first, true);  // out over a border
}

struct DirectionAndNormal {
    SpacePoint direction, normal;
};

/// `at` gives direction and normal at a vertex; the field's strength is 1.
inline SurfaceField field_of_directions(const SurfaceMesh& surface, int n,
                                        const std::function<DirectionAndNormal(SpacePoint)>& at) {
    SurfaceField field{.n = n};
    for (int v = 0; v < surface.vertices(); ++v) {
        const auto [direction, normal] = at(surface.mesh.positions[static_cast<std::size_t>(v)]);
        field.values.push_back(polar(1, n * angle_in_vertex_frame(surface, v, direction, normal)));
    }
    return field;
}

/// Eastwards on a sphere about the z axis.
inline DirectionAndNormal eastward(SpacePoint p) {
    const SpacePoint east = unit(SpacePoint{-p.y, p.x, 0});
    return {abs(east) > 0 ? east : SpacePoint{1, 0, 0}, unit(p)};
}

/// In the plane z = 0, at an angle to +x that depends on the place.
inline SurfaceField field_of_angles(const SurfaceMesh& surface, int n, const std::function<double(double, double)>& angle) {
    return field_of_directions(surface, n, [&](SpacePoint p) {
        const Complex way = polar(1, angle(p.x, p.y));
        return DirectionAndNormal{{way.x, way.y, 0}, {0, 0, 1}};
    });
}

/// A direction in space in the frame of a face, of length 1.
inline Complex in_face(const SurfaceMesh& surface, int face, SpacePoint direction) {
    const auto& frame = surface.frame[static_cast<std::size_t>(face)];
    const Complex flat{dot(direction, frame[0]), dot(direction, frame[1])};
    return flat / abs(flat);
}

}  // namespace rinceau
