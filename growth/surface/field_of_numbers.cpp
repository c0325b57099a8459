// The gradient at a vertex is the mean of its faces' gradients by their corners' angles, each turned with the middle of its
// corner into the vertex's frame.

#include "growth/surface/field_of_numbers.h"

#include "growth/surface/field_filled.h"
#include "growth/surface/vertex_axes.h"

namespace rinceau {

SurfaceField field_of_numbers(const SurfaceMesh& surface, std::vector<double> numbers, const std::string& label) {
    const auto at = [](int i) { return static_cast<std::size_t>(i); };
    SurfaceField field{.n = 1, .scalar = std::move(numbers), .label = label};
    field.values.assign(at(surface.vertices()), Complex{1, 0});
    (void)filled_field(surface, field);  // says what is wrong with the numbers
    std::vector<double> angles(field.values.size(), 0);
    field.values.assign(angles.size(), Complex{});
    for (int f = 0; f < surface.faces(); ++f) {
        const auto& corner = surface.mesh.triangles[at(f)];
        const auto& flat = surface.flat[at(f)];
        const double first = field.scalar[at(corner[0])];
        const double by_x = (field.scalar[at(corner[1])] - first) / flat[1].x;
        const double by_y = (field.scalar[at(corner[2])] - first - flat[2].x * by_x) / flat[2].y;
        for (int h = 3 * f; h < 3 * f + 3; ++h) {
            const double angle = corner_angle(surface, h);
            field.values[at(start_of(surface, h))] += angle * (Complex{by_x, by_y} * corner_to_vertex(surface, h));
            angles[at(start_of(surface, h))] += angle;
        }
    }
    for (std::size_t v = 0; v < angles.size(); ++v) field.values[v] = field.values[v] / angles[v];
    return field;
}

}  // namespace rinceau
