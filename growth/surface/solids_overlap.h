#pragma once
// Do two placed shapes overlap as they are drawn? For checks: it uses the shapes' meshes, not the bodies that stand for them
// while they are placed.

#include "growth/surface/grammar_shape.h"

namespace rinceau {

struct PlacedSolid {
    const GrammarShape* shape = nullptr;
    SpacePoint position;
    std::array<SpacePoint, 3> axes;
    SpacePoint size{1, 1, 1};
};

/// Of the shape's box in its place.
SpacePoint centre_of(const PlacedSolid& solid);
double radius_of(const PlacedSolid& solid);

/// Both shrunk by the factor about their centres. The convex hulls of the meshes (of a shape without a mesh, its box) are
/// compared; if one of them collides by its outline and they lie nearly parallel, also the area that their outlines share.
bool solids_overlap(const PlacedSolid& a, const PlacedSolid& b, double shrink);

}  // namespace rinceau
