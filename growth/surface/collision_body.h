#pragma once
// A placed shape as collision sees it.

#include <array>
#include <span>

#include "growth/surface/grammar_shape.h"

namespace rinceau {

/// A shape in its place, as collision sees it.
struct CollisionBody {
    SpacePoint centre;               ///< of its box
    std::array<SpacePoint, 3> axes;  ///< of length 1, at right angles
    SpacePoint half;                 ///< half lengths of the box
    SpacePoint normal;               ///< of the surface below
    CollideAs collide = CollideAs::box;
    double rim =
        0;  ///< disc, which fills the box with an ellipse: share of the radius that is rounded, 0 a cylinder, 1 a ball
    double below = 0;                 ///< length of the box, along axis 2, that lies under the surface
    const Region* outline = nullptr;  ///< outline: in the plane of axes 0 and 1, unit scope; outlives the space
    std::span<const Point> hull;      ///< hull: likewise, convex, counter-clockwise
    Point outline_scale{1, 1};
    Point outline_shift;  ///< from the box's centre to the outline's origin, in the plane of axes 0 and 1
};

/// A placed shape with its pose as a body. `lift` is how far the position is above the surface. What has no outline or no
/// hull although it collides as one is a box.
CollisionBody collision_body(const GrammarShape& shape, SpacePoint position, const std::array<SpacePoint, 3>& axes,
                             SpacePoint size, SpacePoint normal, double lift = 0);

/// Of a sphere about the centre that holds the body.
double radius_of(const CollisionBody& body);

/// The body without what lies under the surface.
CollisionBody above_surface(const CollisionBody& body);

}  // namespace rinceau
