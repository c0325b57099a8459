#include "growth/surface/collision_body.h"

#include <algorithm>
#include <cmath>

namespace rinceau {
namespace {

/// A scope that leans more than this (cosine) has no plain part above the surface.
constexpr double upright = 0.9;

/// What lies flat collides as if it were this high, in shares of its smaller width: on a bent surface two plates that cover
/// each other do not lie in one plane.
constexpr double least_height = 0.1;

CollideAs kind_of(const GrammarShape& shape) {
    if (shape.collide == CollideAs::hull && shape.hull.size() < 3) return CollideAs::box;
    if (shape.collide == CollideAs::outline && shape.outline.empty()) return CollideAs::box;
    return shape.collide;
}

}  // namespace

CollisionBody collision_body(const GrammarShape& shape, SpacePoint position, const std::array<SpacePoint, 3>& axes,
                             SpacePoint size, SpacePoint normal, double lift) {
    const SpacePoint middle = 0.5 * (shape.low + shape.high), extent = 0.5 * (shape.high - shape.low);
    const SpacePoint to_centre{middle.x * size.x, middle.y * size.y, middle.z * size.z};
    CollisionBody body{.centre = position + to_centre.x * axes[0] + to_centre.y * axes[1] + to_centre.z * axes[2],
                       .axes = axes,
                       .half = {extent.x * size.x, extent.y * size.y, extent.z * size.z},
                       .normal = normal,
                       .collide = kind_of(shape),
                       .rim = shape.rim,
                       .outline = &shape.outline,
                       .hull = shape.hull,
                       .outline_scale = {size.x, size.y},
                       .outline_shift = {-to_centre.x, -to_centre.y}};
    body.half.z = std::max(body.half.z, least_height * std::min(body.half.x, body.half.y));
    const double bottom = lift + to_centre.z - body.half.z;
    if (dot(axes[2], normal) > upright) body.below = std::clamp(-bottom, 0.0, 2 * body.half.z);
    return body;
}

double radius_of(const CollisionBody& body) { return abs(body.half); }

CollisionBody above_surface(const CollisionBody& body) {
    CollisionBody above = body;
    above.centre = body.centre + 0.5 * body.below * body.axes[2];
    above.half.z = body.half.z - 0.5 * body.below;
    above.below = 0;
    return above;
}

}  // namespace rinceau
