#include "editor/model/orbit_view.h"

#include <algorithm>
#include <cmath>

#include "geometry/angle.h"

namespace rinceau {
namespace {

constexpr double margin = 1.08;  // of the view around what is fitted into it

/// Nearness of the triangle's plane under the origin of the view, if the triangle covers it.
std::optional<double> nearness_under(const std::array<SpacePoint, 3>& seen) {
    const auto side = [&](std::size_t i, std::size_t j) { return seen[i].x * seen[j].y - seen[j].x * seen[i].y; };
    const double a = side(1, 2), b = side(2, 0), c = side(0, 1), sum = a + b + c;
    if (sum == 0 || a * sum < 0 || b * sum < 0 || c * sum < 0) return std::nullopt;
    return (a * seen[0].z + b * seen[1].z + c * seen[2].z) / sum;
}

struct Hit {
    int face = -1;
    std::array<double, 3> weights{};
    double nearness = 0;
};

Hit nearest_hit(const SurfaceMesh& surface, const OrbitView& view, Point at) {
    const OrbitFrame frame = orbit_frame(view);
    const double dx = (at.x - view.size.x / 2) / view.zoom, dy = (view.size.y / 2 - at.y) / view.zoom;
    const auto seen = [&](SpacePoint p) {
        const SpacePoint q = p - view.centre;
        return SpacePoint{dot(q, frame.right) - dx, dot(q, frame.up) - dy, dot(q, frame.towards)};
    };
    Hit best;
    for (int f = 0; f < surface.faces(); ++f) {
        std::array<SpacePoint, 3> corners;
        for (std::size_t k = 0; k < 3; ++k) {
            const int v = surface.mesh.triangles[static_cast<std::size_t>(f)][k];
            corners[k] = seen(surface.mesh.positions[static_cast<std::size_t>(v)]);
        }
        const auto nearness = nearness_under(corners);
        if (!nearness || (best.face >= 0 && *nearness <= best.nearness)) continue;
        const auto side = [&](std::size_t i, std::size_t j) {
            return corners[i].x * corners[j].y - corners[j].x * corners[i].y;
        };
        const double sum = side(1, 2) + side(2, 0) + side(0, 1);
        best = {f, {side(1, 2) / sum, side(2, 0) / sum, side(0, 1) / sum}, *nearness};
    }
    return best;
}

}  // namespace

OrbitFrame orbit_frame(const OrbitView& view) {
    const double s = std::sin(view.azimuth), c = std::cos(view.azimuth);
    const double rise = std::sin(view.elevation), flat = std::cos(view.elevation);
    const auto in_space = [&](double right, double front, double up) {  // front towards an eye that has not turned
        return view.z_up ? SpacePoint{right, -front, up} : SpacePoint{right, up, front};
    };
    return {in_space(c, -s, 0), in_space(-s * rise, -c * rise, flat), in_space(s * flat, c * flat, rise)};
}

SeenPlace seen_at(const OrbitView& view, SpacePoint place) {
    const OrbitFrame frame = orbit_frame(view);
    const SpacePoint q = place - view.centre;
    return {{view.size.x / 2 + view.zoom * dot(q, frame.right), view.size.y / 2 - view.zoom * dot(q, frame.up)},
            dot(q, frame.towards)};
}

OrbitView fitted_to(OrbitView view, SpacePoint low, SpacePoint high) {
    view.centre = 0.5 * (low + high);
    const OrbitFrame frame = orbit_frame(view);
    const SpacePoint half = 0.5 * (high - low);
    const auto reach = [&](SpacePoint way) {
        return std::abs(way.x) * half.x + std::abs(way.y) * half.y + std::abs(way.z) * half.z;
    };
    constexpr double smallest = 1e-12;
    const double wide = view.size.x / (2 * std::max(reach(frame.right), smallest));
    const double high_enough = view.size.y / (2 * std::max(reach(frame.up), smallest));
    view.zoom = std::min(wide, high_enough) / margin;
    return view;
}

OrbitView turned_by(OrbitView view, Point pixels) {
    const double across = std::max(1.0, std::min(view.size.x, view.size.y));
    view.azimuth = wrap_angle(view.azimuth - pi * pixels.x / across);
    view.elevation = std::clamp(view.elevation + pi * pixels.y / across, -pi / 2, pi / 2);
    return view;
}

OrbitView panned_by(OrbitView view, Point pixels) {
    const OrbitFrame frame = orbit_frame(view);
    view.centre = view.centre - (pixels.x / view.zoom) * frame.right + (pixels.y / view.zoom) * frame.up;
    return view;
}

OrbitView zoomed_at(OrbitView view, Point at, double factor) {
    const Point from_middle = at - 0.5 * view.size;
    view = panned_by(view, -from_middle);
    view.zoom *= factor;
    return panned_by(view, from_middle);
}

std::optional<SurfacePoint> surface_point_under(const SurfaceMesh& surface, const OrbitView& view, Point at) {
    const Hit hit = nearest_hit(surface, view, at);
    if (hit.face < 0) return std::nullopt;
    return from_barycentric(surface, hit.face, hit.weights);
}

bool is_seen(const SurfaceMesh& surface, const OrbitView& view, SpacePoint place) {
    const SeenPlace seen = seen_at(view, place);
    const Hit hit = nearest_hit(surface, view, seen.at);
    const double slack = 0.01 * surface.diagonal;  // the surface itself about a point at its rim
    return hit.face < 0 || hit.nearness <= seen.nearness + slack;
}

}  // namespace rinceau
