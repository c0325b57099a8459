// Matching of rings: the paper's figure 4, nearest places, and turns.

#include "growth/arrangement/match_ring.h"

#include <catch2/catch.hpp>

#include "geometry/angle.h"
#include "tests/growth/lattice_points.h"

namespace rinceau {

namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();

// Three of the six neighbours on a hexagonal grid of step 10, turned by `angle`, in ring order.
TargetRing three_neighbors(double angle, int first) {
    TargetRing ring;
    for (int k = first; k < first + 3; ++k) {
        RingNeighbor neighbor;
        neighbor.node = k;
        neighbor.offset = polar(10, angle + k * pi / 3);
        ring.inner.push_back(neighbor);
    }
    return ring;
}

struct Hexagons {
    Exemplar exemplar = make_exemplar(lattice_kinds()[2].points, {"A"}, {.find_lattice = false}, "hexagonal");
    int usable = 0;
    Hexagons() {
        while (!exemplar.elements[static_cast<std::size_t>(usable)].usable) ++usable;
        exemplar.lattice.reset();
    }
    const std::vector<Point>& offsets() const { return exemplar.elements[static_cast<std::size_t>(usable)].ring.offsets; }
};

}  // namespace

TEST_CASE("cyclic matching pairs neighbours in their order with consecutive places, none skipped") {
    const Hexagons hexagons;
    const ArrangeOptions options{.matching = RingMatching::cyclic};
    const ArrangeSurroundings around;
    const GrowthGround ground = make_ground(hexagons.exemplar, around, options);
    RingMatcher matcher(ground, paper_weights());
    for (int first = 0; first < 6; ++first) {
        const ReferenceMatch match = matcher.match(three_neighbors(0, first), hexagons.usable, 0, 0, no_limit);
        REQUIRE(match.places.size() == 3);
        CHECK(match.cost == Approx(0).margin(1e-9));
        for (std::size_t i = 0; i < 3; ++i) {
            const Point place = hexagons.offsets()[static_cast<std::size_t>(match.places[i])];
            CHECK(abs(place - polar(10, (first + static_cast<int>(i)) * pi / 3)) < 1e-6);
        }
    }
    // A neighbour that stands between the second and the third place shifts all that come after it.
    TargetRing crowded = three_neighbors(0, 0);
    crowded.inner.insert(crowded.inner.begin() + 2, crowded.inner[1]);
    const ReferenceMatch match = matcher.match(crowded, hexagons.usable, 0, 0, no_limit);
    for (std::size_t i = 1; i < 4; ++i) CHECK(match.places[i] == (match.places[i - 1] + 1) % 6);
    CHECK(match.cost > 0.9);
    // More neighbours than places: such a reference is ignored.
    TargetRing many = three_neighbors(0, 0);
    for (int k = 3; k < 8; ++k) many.inner.push_back(many.inner.back());
    CHECK(matcher.match(many, hexagons.usable, 0, 0, no_limit).reference == -1);
}

TEST_CASE("nearest matching leaves out the neighbour that has no place") {
    const Hexagons hexagons;
    const ArrangeOptions options;
    const ArrangeSurroundings around;
    const GrowthGround ground = make_ground(hexagons.exemplar, around, options);
    RingMatcher matcher(ground, options.weights);
    TargetRing crowded = three_neighbors(0, 0);
    crowded.inner.insert(crowded.inner.begin() + 2, crowded.inner[1]);
    const ReferenceMatch match = matcher.match(crowded, hexagons.usable, 0, 0, no_limit);
    CHECK(match.places[2] == -1);
    CHECK(match.cost == Approx(0.75 + 1));
    CHECK(abs(hexagons.offsets()[static_cast<std::size_t>(match.places[3])] - polar(10, 2 * pi / 3)) < 1e-6);
    CHECK(matcher.match(crowded, hexagons.usable, 0, 0, 1.7).reference == -1);  // it costs more than the limit
}

TEST_CASE("in mode rotate a turned ring fits as well as one that is not") {
    const Hexagons hexagons;
    const ArrangeOptions options{.mode = RotationMode::rotate};
    const ArrangeSurroundings around;
    const GrowthGround ground = make_ground(hexagons.exemplar, around, options);
    RingMatcher matcher(ground, options.weights);
    const double angle = radians(17);
    const ReferenceMatch match = matcher.match(three_neighbors(angle, 1), hexagons.usable, angle, 0, no_limit);
    CHECK(match.cost == Approx(0).margin(1e-6));
    CHECK(match.angle == Approx(angle));  // of six that fit the one that is asked for
}

}  // namespace rinceau
