#include "growth/surface/placed_points.h"

#include <catch2/catch.hpp>

#include "geometry/random.h"

using namespace rinceau;

namespace {

SpacePoint random_point(Random& random) {
    // some of them the same, many near each other
    const double spread = random.below(3) == 0 ? 0.01 : 1;
    const auto coordinate = [&] { return random.below(20) == 0 ? 0.25 : spread * random.uniform(-1, 1); };
    return {coordinate(), coordinate(), coordinate()};
}

}  // namespace

TEST_CASE("nearest points and all within a distance are those that a look at every point finds") {
    Random random(5);
    PlacedPoints points;
    std::vector<SpacePoint> all;
    CHECK_FALSE(points.nearest({0, 0, 0}));
    for (int i = 0; i < 1500; ++i) {
        const bool takes_back = !all.empty() && random.below(4) == 0;
        if (takes_back) {
            points.remove_last();
            all.pop_back();
        } else {
            all.push_back(random_point(random));
            points.add(all.back());
        }
        REQUIRE(points.size() == static_cast<int>(all.size()));
        const SpacePoint p = random_point(random);
        const int except = random.below(2) == 0 || all.empty()
                               ? -1
                               : static_cast<int>(random.below(static_cast<std::uint32_t>(all.size())));
        int best = -1;
        std::vector<int> near;
        for (int k = 0; k < static_cast<int>(all.size()); ++k) {
            const SpacePoint between = all[static_cast<std::size_t>(k)] - p;
            if (dot(between, between) <= 0.3 * 0.3) near.push_back(k);
            const auto square = [&](int index) {
                const SpacePoint d = all[static_cast<std::size_t>(index)] - p;
                return dot(d, d);
            };
            if (k != except && (best < 0 || square(k) < square(best))) best = k;
        }
        CHECK(points.within(p, 0.3) == near);
        const auto nearest = points.nearest(p, except);
        REQUIRE(nearest.has_value() == (best >= 0));
        if (nearest) CHECK(nearest->index == best);
    }
}
