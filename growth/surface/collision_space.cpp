#include "growth/surface/collision_space.h"

#include <algorithm>

#include "growth/surface/sphere_grid.h"

namespace rinceau {

struct CollisionSpace::Rooms {
    CollisionOptions options;
    SphereGrid grid;
    std::vector<CollisionBody> bodies;
};

CollisionSpace::CollisionSpace(const CollisionOptions& options) : rooms_(std::make_unique<Rooms>()) {
    rooms_->options = options;
}
CollisionSpace::~CollisionSpace() = default;
CollisionSpace::CollisionSpace(CollisionSpace&&) noexcept = default;
CollisionSpace& CollisionSpace::operator=(CollisionSpace&&) noexcept = default;

std::optional<int> CollisionSpace::overlap(const CollisionBody& body, std::span<const int> kin) const {
    constexpr double kin_size = 0.5;
    const double full = 1 - rooms_->options.touch;
    int first = size();
    rooms_->grid.visit(body.centre, radius_of(body), [&](int other) {
        if (other >= first) return;
        const bool related = std::find(kin.begin(), kin.end(), other) != kin.end();
        const double shrink = related ? kin_size * full : full;
        if (bodies_overlap(body, rooms_->bodies[static_cast<std::size_t>(other)], shrink, shrink)) first = other;
    });
    if (first == size()) return std::nullopt;
    return first;
}

int CollisionSpace::add(const CollisionBody& body) {
    rooms_->bodies.push_back(body);
    return rooms_->grid.add(body.centre, radius_of(body));
}

void CollisionSpace::remove_from(int first) {
    rooms_->grid.remove_from(first);
    rooms_->bodies.resize(static_cast<std::size_t>(rooms_->grid.size()));
}

int CollisionSpace::size() const { return rooms_->grid.size(); }

std::vector<int> CollisionSpace::near(SpacePoint p, double distance) const {
    std::vector<int> found;
    rooms_->grid.visit(p, distance, [&](int i) {
        if (abs(rooms_->bodies[static_cast<std::size_t>(i)].centre - p) <= distance) found.push_back(i);
    });
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

}  // namespace rinceau
