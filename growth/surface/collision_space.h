#pragma once
// Which shape would overlap which, in double precision; touching is no overlap (Li et al. 2010, section 4.4.1).

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "growth/surface/bodies_overlap.h"

namespace rinceau {

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

}  // namespace rinceau
