// By face the symmetric tensor that best explains, by least squares, how the vertex normals change along its three edges
// (Rusinkiewicz 2004); by vertex the mean of its faces' tensors, each turned with the middle of its corner into the vertex's
// frame and weighted by the corner's angle.

#include "growth/surface/curvature_field.h"

#include <Eigen/Dense>

#include "geometry/index.h"
#include "growth/surface/field_filled.h"
#include "growth/surface/vertex_axes.h"

namespace rinceau {
namespace {

/// (a b; b c) in the face's frame, with tensor * edge = change of the normal along it.
std::array<double, 3> face_tensor(const SurfaceMesh& surface, int face) {
    Eigen::Matrix<double, 6, 3> left = Eigen::Matrix<double, 6, 3>::Zero();
    Eigen::Matrix<double, 6, 1> right;
    const auto& frame = surface.frame[at(face)];
    for (Eigen::Index k = 0; k < 3; ++k) {
        const int h = 3 * face + static_cast<int>(k);
        const Complex edge = edge_vector(surface, h);
        const SpacePoint change =
            surface.vertex_normal[at(end_of(surface, h))] - surface.vertex_normal[at(start_of(surface, h))];
        left.row(2 * k) << edge.x, edge.y, 0;
        left.row(2 * k + 1) << 0, edge.x, edge.y;
        right[2 * k] = dot(change, frame[0]);
        right[2 * k + 1] = dot(change, frame[1]);
    }
    const Eigen::Vector3d found = (left.transpose() * left).ldlt().solve(left.transpose() * right);
    return {found[0], found[1], found[2]};
}

}  // namespace

SurfaceField curvature_field(const SurfaceMesh& surface) {
    SurfaceField field{.n = 2, .label = "curvature"};
    field.values.assign(at(surface.vertices()), Complex{});
    field.isotropic.assign(at(surface.vertices()), 0);
    std::vector<double> angles(at(surface.vertices()), 0);
    for (int f = 0; f < surface.faces(); ++f) {
        const auto [a, b, c] = face_tensor(surface, f);
        for (int h = 3 * f; h < 3 * f + 3; ++h) {
            const auto v = at(start_of(surface, h));
            const double weight = corner_angle(surface, h);
            field.values[v] += weight * (Complex{(a - c) / 2, b} * power(corner_to_vertex(surface, h), 2));
            field.isotropic[v] += weight * (a + c) / 2;
            angles[v] += weight;
        }
    }
    for (std::size_t v = 0; v < angles.size(); ++v) {
        field.values[v] = field.values[v] / angles[v];
        field.isotropic[v] /= angles[v];
    }
    return field;
}

SurfaceField guiding_curvature_field(const SurfaceMesh& surface) {
    constexpr double noise = 0.05;  // of 1 / diagonal
    SurfaceField field = curvature_field(surface);
    for (Complex& z : field.values) z = z * (abs(z) / (abs(z) + noise / surface.diagonal));
    return field;
}

}  // namespace rinceau
