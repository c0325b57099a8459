#include "growth/surface/surface_point.h"

#include <cmath>

#include "geometry/index.h"

namespace rinceau {

std::array<double, 3> barycentric(const SurfaceMesh& surface, SurfacePoint p) {
    const auto& flat = surface.flat[at(p.face)];
    const double doubled = flat[1].x * flat[2].y;
    const double b2 = p.at.y / flat[2].y;
    const double b1 = (p.at.x * flat[2].y - p.at.y * flat[2].x) / doubled;
    return {1 - b1 - b2, b1, b2};
}

SurfacePoint from_barycentric(const SurfaceMesh& surface, int face, const std::array<double, 3>& weights) {
    const auto& flat = surface.flat[at(face)];
    return {face, weights[1] * flat[1] + weights[2] * flat[2]};
}

SpacePoint position_in_space(const SurfaceMesh& surface, SurfacePoint p) {
    const auto weights = barycentric(surface, p);
    SpacePoint sum;
    for (std::size_t k = 0; k < 3; ++k)
        sum = sum + weights[k] * surface.mesh.positions[at(surface.mesh.triangles[at(p.face)][k])];
    return sum;
}

SpacePoint direction_in_space(const SurfaceMesh& surface, int face, Complex direction) {
    const auto& frame = surface.frame[at(face)];
    return direction.x * frame[0] + direction.y * frame[1];
}

SpacePoint normal_at(const SurfaceMesh& surface, SurfacePoint p) {
    const auto weights = barycentric(surface, p);
    SpacePoint sum;
    for (std::size_t k = 0; k < 3; ++k)
        sum = sum + weights[k] * surface.vertex_normal[at(surface.mesh.triangles[at(p.face)][k])];
    // opposite normals of a sharp edge can cancel out
    return abs(sum) > 1e-6 ? unit(sum) : surface.frame[at(p.face)][2];
}

SurfacePoint at_vertex(const SurfaceMesh& surface, int v) {
    const int h = surface.outgoing[at(v)];
    return {face_of(h), surface.flat[at(face_of(h))][at(h % 3)]};
}

Complex from_vertex_frame(const SurfaceMesh& surface, int v, Complex direction) {
    const int h = surface.outgoing[at(v)];
    const Complex along = edge_vector(surface, h);
    return direction * polar(1, -surface.angle[at(h)]) * (along / abs(along));
}

SurfacePoint random_surface_point(const SurfaceMesh& surface, Random& random) {
    double rest = random.uniform() * surface.area;
    int face = 0;
    for (; face + 1 < surface.faces(); ++face) {
        rest -= cross(surface.flat[at(face)][1], surface.flat[at(face)][2]) / 2;
        if (rest < 0) break;
    }
    const double root = std::sqrt(random.uniform()), share = random.uniform();
    return from_barycentric(surface, face, {1 - root, root * (1 - share), root * share});
}

}  // namespace rinceau
