// The paper names these queries but not how they are computed. Values of the corners are turned into the face's frame with
// the middles of the corners (as a walk along the median carries them); between them the change is linear. Closed forms of
// the plane are differentiated by central differences.

#include "growth/surface/field_gradient.h"

#include <cmath>

#include "geometry/index.h"
#include "growth/surface/field_filled.h"
#include "growth/surface/vertex_axes.h"

namespace rinceau {
namespace {

/// Corner values, in the frame of their face, to the gradient of the function that is linear between them.
VectorGradient linear_gradient(const SurfaceMesh& surface, int face, const std::array<Complex, 3>& values) {
    const auto& flat = surface.flat[at(face)];
    const Complex by_x = (values[1] - values[0]) / flat[1].x;
    return {by_x, (values[2] - values[0] - flat[2].x * by_x) / flat[2].y};
}

std::array<Complex, 3> corner_values(const FieldOnSurface& field, int face) {
    std::array<Complex, 3> values;
    for (int k = 0; k < 3; ++k) {
        const int h = 3 * face + k;
        const Complex to_face = conj(corner_to_vertex(field.surface(), h));
        values[at(k)] = field.field().values[at(start_of(field.surface(), h))] * power(to_face, field.n());
    }
    return values;
}

/// value(z in the face's frame) at places around p, for fields that are known everywhere on the plane.
template <class Value>
VectorGradient plane_gradient(const FieldOnSurface& field, SurfacePoint p, Value value) {
    const double step = field.plane_step();
    const auto change = [&](Complex way) {
        return (value(field.at({p.face, p.at + step * way})) - value(field.at({p.face, p.at - step * way}))) / (2 * step);
    };
    return {change({1, 0}), change({0, 1})};
}

}  // namespace

VectorGradient vector_gradient(const FieldOnSurface& field, SurfacePoint p, Complex branch) {
    const auto vector = [&](Complex z) { return field.n() == 1 ? z : root_near(z, field.n(), branch); };
    if (field.plane_step() > 0) return plane_gradient(field, p, vector);
    branch = root_near(field.at(p), field.n(), branch);
    std::array<Complex, 3> values = corner_values(field, p.face);
    for (Complex& value : values) value = vector(value);
    return linear_gradient(field.surface(), p.face, values);
}

VectorGradient value_gradient(const FieldOnSurface& field, SurfacePoint p) {
    if (field.plane_step() > 0) return plane_gradient(field, p, [](Complex z) { return z; });
    return linear_gradient(field.surface(), p.face, corner_values(field, p.face));
}

Complex scalar_gradient(const FieldOnSurface& field, SurfacePoint p) {
    const SurfaceMesh& surface = field.surface();
    std::array<Complex, 3> values;
    for (std::size_t k = 0; k < 3; ++k) values[k] = {field.scalar_at({p.face, surface.flat[at(p.face)][k]}), 0};
    const VectorGradient gradient = linear_gradient(surface, p.face, values);
    return {gradient.by_x.x, gradient.by_y.x};
}

}  // namespace rinceau
