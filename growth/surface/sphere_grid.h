#pragma once
// Balls in space by size and place: what may touch a ball, in a time that does not depend on how many there are.

#include <cmath>
#include <cstdint>
#include <vector>

#include "geometry/index_map.h"
#include "growth/mesh/triangle_mesh.h"

namespace rinceau {

/// Cubic cells in levels: cells of level k are 2^k wide and hold balls of up to that diameter by their centres. Balls that
/// are much smaller than half of all are kept in wider cells, so that few levels are in use. A value.
class SphereGrid {
  public:
    /// Numbers rise from 0. The centre must be finite; radius >= 0.
    int add(SpacePoint centre, double radius);
    /// Takes back everything from number `first` on.
    void remove_from(int first);
    int size() const { return static_cast<int>(balls_.size()); }

    /// Calls visit(number) for every ball that touches or overlaps this one; a few may come twice, in an order that only
    /// depends on what was done to the grid before.
    template <class Visit>
    void visit(SpacePoint centre, double radius, Visit&& visit_ball) const {
        for (const Level& level : levels_) {
            if (level.count == 0) continue;
            const double reach = radius + 0.5 * level.cell;
            const Cell low = cell_of(centre - SpacePoint{reach, reach, reach}, level.cell);
            const Cell high = cell_of(centre + SpacePoint{reach, reach, reach}, level.cell);
            const double cells = static_cast<double>(high.x - low.x + 1) * static_cast<double>(high.y - low.y + 1) *
                                 static_cast<double>(high.z - low.z + 1);
            if (cells > static_cast<double>(level.count)) {  // quicker to look at all of them
                for (int i = level.last; i >= 0; i = balls_[static_cast<std::size_t>(i)].before_in_level)
                    if (touch(i, centre, radius)) visit_ball(i);
                continue;
            }
            for (std::int64_t z = low.z; z <= high.z; ++z)
                for (std::int64_t y = low.y; y <= high.y; ++y)
                    for (std::int64_t x = low.x; x <= high.x; ++x) {
                        const int slot = slots_.find(key_of({x, y, z}, level.number));
                        if (slot < 0) continue;
                        for (int i = last_in_slot_[static_cast<std::size_t>(slot)]; i >= 0;
                             i = balls_[static_cast<std::size_t>(i)].before_in_slot)
                            if (touch(i, centre, radius)) visit_ball(i);
                    }
        }
    }

  private:
    struct Ball {
        SpacePoint centre;
        double radius = 0;
        int before_in_slot = -1, before_in_level = -1;
        int slot = 0, level = 0;  // level: index into levels_
        int natural_level = 0;    // by the radius alone
    };
    struct Level {
        int number = 0;
        double cell = 1;
        int count = 0, last = -1;
    };
    struct Cell {
        std::int64_t x = 0, y = 0, z = 0;
    };

    static Cell cell_of(SpacePoint p, double cell) {
        // Far out cells are shared: slower, not wrong.
        constexpr double far = 1e9;
        const auto index = [&](double v) {
            return static_cast<std::int64_t>(std::floor(std::fmin(std::fmax(v / cell, -far), far)));
        };
        return {index(p.x), index(p.y), index(p.z)};
    }
    /// Cells that share a key share a slot: slower, not wrong.
    static std::uint64_t key_of(Cell c, int level) {
        const auto mixed = [](std::uint64_t h, std::int64_t v) {
            h = (h ^ static_cast<std::uint64_t>(v)) * 0xBF58476D1CE4E5B9ULL;
            return h ^ (h >> 29U);
        };
        return mixed(mixed(mixed(static_cast<std::uint64_t>(level) + 0x94D049BB133111EBULL, c.x), c.y), c.z);
    }
    bool touch(int ball, SpacePoint centre, double radius) const {
        const Ball& other = balls_[static_cast<std::size_t>(ball)];
        const SpacePoint apart = other.centre - centre;
        const double reach = other.radius + radius;
        return dot(apart, apart) <= reach * reach;
    }
    void hook(int ball);
    void choose_floor();

    std::vector<Ball> balls_;
    std::vector<Level> levels_;      // by rising number
    IndexMap slots_;                 // cell -> slot
    std::vector<int> last_in_slot_;  // the newest ball
    int floor_ = 0;                  // lowest level in use
    int next_choice_ = 1;            // balls at which the floor is chosen anew
};

}  // namespace rinceau
