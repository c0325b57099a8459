#include "growth/surface/start_place.h"

#include <algorithm>
#include <cmath>

namespace rinceau {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

constexpr double good_stretch = 1.25;  // of a group of elements
constexpr int places = 60;
constexpr double largest_disc = 0.2;  // of the diagonal

/// Share of the disc that is there and hardly stretched.
double flat_share(const SurfaceMesh& surface, PatchMaker& patches, SurfacePoint place, double radius) {
    double good = 0;
    for (const ChartTriangle& triangle : patches.patch(place, {1, 0}, radius)) {
        const auto& q = triangle.at;
        const Complex middle = (1.0 / 3) * (q[0] + q[1] + q[2]);
        if (abs(middle) > radius || chart_stretch(surface, triangle) > good_stretch) continue;
        good += 0.5 * cross(q[1] - q[0], q[2] - q[0]);
    }
    return good / (pi * radius * radius);
}

/// Is nothing of the surface between the place and an eye far away?
bool is_seen(const SurfaceMesh& surface, SurfacePoint place, SpacePoint eye) {
    const SpacePoint from = position_in_space(surface, place);
    for (int face = 0; face < surface.faces(); ++face) {
        if (face == place.face) continue;
        const auto& corners = surface.mesh.triangles[at(face)];
        const SpacePoint a = surface.mesh.positions[at(corners[0])];
        const SpacePoint u = surface.mesh.positions[at(corners[1])] - a, v = surface.mesh.positions[at(corners[2])] - a;
        // Moeller and Trumbore 1997
        const SpacePoint p = cross(eye, v), s = from - a, q = cross(s, u);
        const double determinant = dot(u, p);
        if (determinant == 0) continue;
        const double x = dot(s, p) / determinant, y = dot(eye, q) / determinant, way = dot(v, q) / determinant;
        if (x >= 0 && y >= 0 && x + y <= 1 && way > 1e-6 * surface.diagonal) return false;
    }
    return true;
}

}  // namespace

SurfacePoint start_place(const SurfaceMesh& surface, double radius) {
    const double disc = std::clamp(radius, 1e-3 * surface.diagonal, largest_disc * surface.diagonal);
    const SpacePoint eye = unit({0.3, 0.5, 1});
    constexpr double front = 0.3;  // how much it counts to be seen from the front
    PatchMaker patches(surface);
    Random random(1);
    SurfacePoint best;
    double best_score = -1;
    for (int k = 0; k < places; ++k) {
        const SurfacePoint place = random_surface_point(surface, random);
        const SpacePoint normal = normal_at(surface, place);
        // a place inside of a hole is no place to be looked at
        const double open = is_seen(surface, place, normal) ? 1 : 0;
        const double score = flat_share(surface, patches, place, disc) + front * dot(normal, eye) + open;
        if (score > best_score) {
            best_score = score;
            best = place;
        }
    }
    return best;
}

Complex start_up(const SurfaceMesh& surface, const FieldOnSurface* field, SurfacePoint place) {
    if (field != nullptr) {
        const Complex z = field->at(place);
        if (abs(z) > 0) return polar(1, arg(z) / field->n());
    }
    const auto& frame = surface.frame[at(place.face)];
    constexpr double steep = 0.05;  // sine of the angle to the normal below which there is no up
    for (const SpacePoint& axis : {SpacePoint{0, 1, 0}, SpacePoint{0, 0, -1}}) {
        const Complex up{dot(axis, frame[0]), dot(axis, frame[1])};
        if (abs(up) > steep) return up / abs(up);
    }
    return {1, 0};
}

}  // namespace rinceau
