#pragma once
// Two bodies seen along their common normal: do their outlines share area?

#include "growth/surface/collision_body.h"

namespace rinceau {

/// The outline of the body as its kind says (outline, hull, ellipse, rectangle), shrunk about the centre, laid into a plane:
/// `x` and `y` of length 1 at right angles, `origin` at (0, 0).
Region outline_in_plane(const CollisionBody& body, double shrink, SpacePoint origin, SpacePoint x, SpacePoint y);

/// Of bodies whose third axes are parallel or opposed, nearly: outlines in the plane across the mean of these axes. Touching
/// is not meeting. Heights are not looked at.
bool outlines_meet(const CollisionBody& a, const CollisionBody& b, double shrink_a, double shrink_b);

}  // namespace rinceau
