// Growth of arrangements: lattices come out exact, the seed decides all else, and what stands is always whole.

#include "growth/arrangement/grow_arrangement.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <string>

#include "tests/growth/lattice_points.h"

namespace rinceau {

namespace {

ElementArrangement grown(const Exemplar& exemplar, const ArrangeOptions& options, std::size_t count) {
    ElementArrangement arrangement = with_seed(empty_arrangement(exemplar, options), exemplar, {}, {0, 0});
    return grow(std::move(arrangement), exemplar, {}, {.count = count});
}

// Elements without a seed among their neighbours have grown all around.
bool is_inner(const ElementArrangement& arrangement, const ArrangementNode& node) {
    if (!is_element(node)) return false;
    for (const RingLink& link : node.links)
        if (is_seed(arrangement.nodes[static_cast<std::size_t>(link.other)])) return false;
    return true;
}

}  // namespace

TEST_CASE("growth on a lattice gives every inner element the right neighbours at the right distance") {
    for (const LatticeKind& kind : lattice_kinds()) {
        INFO(kind.name);
        const Exemplar exemplar = make_exemplar(kind.points, kind.symbols, {}, "lattice");
        const ElementArrangement arrangement = grown(exemplar, {}, 1000);
        REQUIRE(arrangement.elements == 1000);
        std::size_t inner = 0;
        for (const ArrangementNode& node : arrangement.nodes) {
            if (!is_inner(arrangement, node)) continue;
            ++inner;
            CHECK(node.links.size() == kind.degree);
            for (const RingLink& link : node.links) {
                CHECK(link.place >= 0);
                const Point offset = arrangement.nodes[static_cast<std::size_t>(link.other)].position - node.position;
                CHECK(abs(offset - link.target) < 1e-3 * exemplar.mean_edge);
            }
        }
        CHECK(inner > 800);
    }
}

TEST_CASE("the same seed grows the same arrangement, another one another") {
    const Exemplar exemplar = make_exemplar(irregular_points(99), {"A", "B"}, {}, "irregular");
    const std::vector<ArrangedElement> once = arranged_elements(grown(exemplar, {.seed = 5}, 300));
    const std::vector<ArrangedElement> again = arranged_elements(grown(exemplar, {.seed = 5}, 300));
    const std::vector<ArrangedElement> other = arranged_elements(grown(exemplar, {.seed = 6}, 300));
    REQUIRE(once.size() == again.size());
    bool differs = false;
    for (std::size_t i = 0; i < once.size(); ++i) {
        CHECK(once[i].reference == again[i].reference);
        CHECK(once[i].position == again[i].position);
        differs |= other[i].position != once[i].position;
    }
    CHECK(differs);
}

TEST_CASE("growth that is stopped stands as it is and can go on to what it would have become") {
    const Exemplar exemplar = make_exemplar(irregular_points(99), {"A", "B"}, {}, "irregular");
    ElementArrangement arrangement = with_seed(empty_arrangement(exemplar, {}), exemplar, {}, {0, 0});
    int asked = 0;
    arrangement = grow(std::move(arrangement), exemplar, {}, {.count = 300, .stop = [&] { return ++asked > 100; }});
    CHECK(arrangement.elements > 50);
    CHECK(arrangement.elements < 300);
    arrangement = grow(std::move(arrangement), exemplar, {}, {.count = 300});
    const std::vector<ArrangedElement> in_two = arranged_elements(arrangement);
    const std::vector<ArrangedElement> in_one = arranged_elements(grown(exemplar, {}, 300));
    REQUIRE(in_two.size() == in_one.size());
    for (std::size_t i = 0; i < in_one.size(); ++i) CHECK(in_two[i].position == in_one[i].position);
}

}  // namespace rinceau
