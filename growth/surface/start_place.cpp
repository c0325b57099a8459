#include "growth/surface/start_place.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "geometry/angle.h"
#include "geometry/index.h"

namespace rinceau {
namespace {

constexpr double good_stretch = 1.25;  // of a group of elements
constexpr int places = 60;
constexpr double largest_disc = 0.2;  // of the diagonal

/// Share of the disc that is there, hardly stretched, and seen when looked at from straight above its middle.
double flat_share(const SurfaceMesh& surface, PatchMaker& patches, SurfacePoint place, double radius) {
    const SpacePoint above = normal_at(surface, place);
    double good = 0;
    for (const ChartTriangle& triangle : patches.patch(place, {1, 0}, radius)) {
        const auto& q = triangle.at;
        const Complex middle = (1.0 / 3) * (q[0] + q[1] + q[2]);
        if (abs(middle) > radius || chart_stretch(surface, triangle) > good_stretch) continue;
        good += 0.5 * cross(q[1] - q[0], q[2] - q[0]) * std::max(0.0, dot(surface.frame[at(triangle.face)][2], above));
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

/// Share of the directions about the normal from which the place is seen.
double openness(const SurfaceMesh& surface, SurfacePoint place) {
    const auto& frame = surface.frame[at(place.face)];
    constexpr int around = 8;
    constexpr double leaning = 45 * pi / 180;
    int seen = is_seen(surface, place, frame[2]) ? around : 0;  // straight above counts as much as all others
    for (int k = 0; k < around; ++k) {
        const Complex side = polar(std::sin(leaning), two_pi * k / around);
        const SpacePoint eye = side.x * frame[0] + side.y * frame[1] + std::cos(leaning) * frame[2];
        seen += is_seen(surface, place, eye) ? 1 : 0;
    }
    return 0.5 * seen / around;
}

}  // namespace

SurfacePoint start_place(const SurfaceMesh& surface, double radius) {
    const double disc = std::clamp(radius, 1e-3 * surface.diagonal, largest_disc * surface.diagonal);
    const SpacePoint eye = unit({0.3, 0.5, 1});
    constexpr double front = 0.3;  // how much it counts to be seen from the front
    PatchMaker patches(surface);
    Random random(1);
    std::vector<std::pair<double, SurfacePoint>> candidates;
    for (int k = 0; k < places; ++k) {
        const SurfacePoint place = random_surface_point(surface, random);
        candidates.push_back(
            {flat_share(surface, patches, place, disc) + front * dot(normal_at(surface, place), eye), place});
    }
    // a place inside of a hole is no place to be looked at; finding that out takes long, so the best are asked first
    std::ranges::stable_sort(candidates, std::ranges::greater{}, [](const auto& candidate) { return candidate.first; });
    SurfacePoint best = candidates.front().second;
    double best_score = -1;
    for (const auto& [score, place] : candidates) {
        if (score + 1 <= best_score) break;
        const double seen = score + openness(surface, place);
        if (seen <= best_score) continue;
        best_score = seen;
        best = place;
    }
    return best;
}

Complex start_up(const SurfaceMesh& surface, const FieldOnSurface* field, SurfacePoint place) {
    const auto& frame = surface.frame[at(place.face)];
    constexpr double steep = 0.05;  // sine of the angle to the normal below which there is no up
    Complex up{1, 0};
    for (const SpacePoint& axis : {SpacePoint{0, 0, -1}, SpacePoint{0, 1, 0}}) {
        const Complex seen{dot(axis, frame[0]), dot(axis, frame[1])};
        if (abs(seen) > steep) up = seen / abs(seen);
    }
    if (field == nullptr || !(abs(field->at(place)) > 0)) return up;
    // of the field's directions the one that is nearest to that
    const double angle = arg(field->at(place)) / field->n(), part = two_pi / field->n();
    return polar(1, angle + part * std::round(wrap_angle(arg(up) - angle) / part));
}

}  // namespace rinceau
