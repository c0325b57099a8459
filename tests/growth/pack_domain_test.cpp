// Density pictures between their pixels.

#include <catch2/catch.hpp>

#include "growth/aggregate/pack_domain.h"

namespace rinceau {

TEST_CASE("a density picture is met at the middle of its pixels and is even beyond its edge") {
    const DensityPicture picture{.columns = 2, .rows = 2, .values = {0, 1, 0.5, 0.25}, .box = {{0, 0}, {20, 10}}};
    CHECK(density_at(picture, {5, 7.5}) == Approx(0));  // rows run from the top
    CHECK(density_at(picture, {15, 7.5}) == Approx(1));
    CHECK(density_at(picture, {5, 2.5}) == Approx(0.5));
    CHECK(density_at(picture, {10, 5}) == Approx((0 + 1 + 0.5 + 0.25) / 4));
    CHECK(density_at(picture, {-100, 100}) == Approx(0));
    CHECK(density_at(picture, {100, -100}) == Approx(0.25));
}

}  // namespace rinceau
