// Li et al. 2010, sections 3.1 and 3.4. A rotation about Z of a scope that nothing has tilted turns its X in the surface and
// so the way that translations take; every other rotation tilts the axes and leaves the ways alone: the paper does not say
// where a tilted scope walks.
#include "growth/surface/shape_scope.h"

#include <cmath>

#include "geometry/angle.h"

namespace rinceau {

namespace {

using Quaternion = std::array<double, 4>;

/// First b, then a.
Quaternion product(const Quaternion& a, const Quaternion& b) {
    return {a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1], a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
            a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3], a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2]};
}

SpacePoint turned(const Quaternion& q, SpacePoint p) {
    const SpacePoint axis{q[0], q[1], q[2]};
    const SpacePoint twice = 2 * cross(axis, p);
    return p + q[3] * twice + cross(axis, twice);
}

void tilt_about(ShapeScope& scope, SpacePoint axis, double degrees) {
    scope.tilt = product(scope.tilt, rotation_about(axis, degrees * pi / 180));
    scope.tilted = true;
}

}  // namespace

ScopeFrame frame_in_space(const SurfaceMesh& surface, const ShapeScope& scope) {
    const SpacePoint n = normal_at(surface, scope.at);
    const SpacePoint along = direction_in_space(surface, scope.at.face, scope.x);
    const SpacePoint x = unit(along - dot(along, n) * n);
    const SpacePoint y = cross(n, x);
    ScopeFrame frame{position_in_space(surface, scope.at), {x, y, n}, n, scope.offset};
    if (scope.offset != 0) frame.position = frame.position + scope.offset * n;
    if (!scope.tilted) return frame;
    for (std::size_t k = 0; k < 3; ++k) {
        const SpacePoint axis = turned(scope.tilt, {k == 0 ? 1.0 : 0.0, k == 1 ? 1.0 : 0.0, k == 2 ? 1.0 : 0.0});
        frame.axes[k] = axis.x * x + axis.y * y + axis.z * n;
    }
    return frame;
}

void turn_about_x(ShapeScope& scope, double degrees) { tilt_about(scope, {1, 0, 0}, degrees); }
void turn_about_y(ShapeScope& scope, double degrees) { tilt_about(scope, {0, 1, 0}, degrees); }

void turn_about_z(ShapeScope& scope, double degrees) {
    if (scope.tilted) return tilt_about(scope, {0, 0, 1}, degrees);
    const Complex turn = polar(1, degrees * pi / 180);
    scope.x = scope.x * turn;
    scope.chart_x = scope.chart_x * turn;
}

int ShapeKin::with(int kin, int placed) {
    links.push_back({placed, kin});
    return static_cast<int>(links.size()) - 1;
}

std::vector<int> ShapeKin::last(int kin, int count) const {
    std::vector<int> result;
    for (; kin >= 0 && static_cast<int>(result.size()) < count; kin = links[static_cast<std::size_t>(kin)].before)
        result.push_back(links[static_cast<std::size_t>(kin)].placed);
    return result;
}

}  // namespace rinceau
