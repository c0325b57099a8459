#pragma once
// Which shape would overlap which, in double precision; touching is no overlap (Li et al. 2010, section 4.4.1).

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "growth/surface/grammar_shape.h"

namespace rinceau {

/// A shape in its place, as collision sees it.
struct CollisionBody {
    SpacePoint centre;               ///< of its box
    std::array<SpacePoint, 3> axes;  ///< of length 1, at right angles
    SpacePoint half;                 ///< half lengths of the box
    SpacePoint normal;               ///< of the surface below
    CollideAs collide = CollideAs::box;
    double round = 0;  ///< disc: radius about the centre
    const Region* outline =
        nullptr;  ///< hull, outline: in the plane of axes 0 and 1 about the centre, unit scope; outlives the space
    SpacePoint outline_scale{1, 1, 1};
    Point outline_shift;  ///< from the box's centre to the outline's origin, in the plane of axes 0 and 1
};

/// A placed shape with its pose as a body.
CollisionBody collision_body(const GrammarShape& shape, SpacePoint position, const std::array<SpacePoint, 3>& axes,
                             SpacePoint size, SpacePoint normal);

struct CollisionOptions {
    double touch = 0.02;  ///< share by which bodies are shrunk
};

class CollisionSpace {
  public:
    explicit CollisionSpace(const CollisionOptions& options = {});
    ~CollisionSpace();
    CollisionSpace(CollisionSpace&&) noexcept;
    CollisionSpace& operator=(CollisionSpace&&) noexcept;

    /// The first body added (by number) that overlaps this one. Against those of `kin` (a shape's own ancestors, which it
    /// may touch) both bodies are halved.
    std::optional<int> overlap(const CollisionBody& body, std::span<const int> kin = {}) const;
    /// Numbers rise from 0.
    int add(const CollisionBody& body);
    /// Takes back everything from number `first` on.
    void remove_from(int first);
    int size() const;
    /// All bodies whose centre is within `distance` of p, by rising number.
    std::vector<int> near(SpacePoint p, double distance) const;

  private:
    struct Rooms;
    std::unique_ptr<Rooms> rooms_;
};

/// The exact test of two bodies, both shrunk to `shrink` about their centres; without a broad phase.
bool bodies_overlap(const CollisionBody& a, const CollisionBody& b, double shrink_a, double shrink_b);

}  // namespace rinceau
