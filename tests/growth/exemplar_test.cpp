// Exemplars: who is whose neighbour, what can be copied, and what is wrong with a drawing that cannot serve as one.

#include <algorithm>
#include <catch2/catch.hpp>

#include "growth/arrangement/exemplar.h"
#include "scene/input_error.h"
#include "tests/growth/point_patterns.h"

namespace rinceau {
namespace {

Exemplar exemplar_of(const std::vector<ExemplarPoint>& points, const ExemplarOptions& options = {}) {
    return make_exemplar(points, {"A", "B"}, options, "example.svg");
}

std::string message_of(const std::vector<ExemplarPoint>& points, const ExemplarOptions& options = {}) {
    try {
        exemplar_of(points, options);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

std::size_t count_usable(const Exemplar& exemplar) {
    return static_cast<std::size_t>(std::ranges::count_if(exemplar.elements, &ExemplarElement::usable));
}

/// Rings are closed walks about their element, counter-clockwise, and every neighbour knows of it.
void check_rings(const Exemplar& exemplar) {
    for (std::size_t i = 0; i < exemplar.elements.size(); ++i) {
        const ExemplarRing& ring = exemplar.elements[i].ring;
        REQUIRE(ring.offsets.size() == ring.elements.size());
        REQUIRE(ring.joined.size() == ring.elements.size());
        double turned = 0;
        for (std::size_t k = 0; k < ring.elements.size(); ++k) {
            const std::size_t next = (k + 1) % ring.elements.size();
            const auto& other = exemplar.elements[static_cast<std::size_t>(ring.elements[k])];
            CHECK(abs(exemplar.elements[i].position + ring.offsets[k] - other.position) < 1e-9);
            CHECK(std::ranges::count(other.ring.elements, static_cast<int>(i)) == 1);
            CHECK((!ring.joined[k] || std::ranges::count(other.ring.elements, ring.elements[next]) == 1));
            turned += std::atan2(cross(ring.offsets[k], ring.offsets[next]), dot(ring.offsets[k], ring.offsets[next]));
        }
        if (exemplar.elements[i].usable) CHECK(turned == Approx(two_pi));
    }
}

}  // namespace

TEST_CASE("on lattices every whole ring has the right number of neighbours, also turned and with a fifth of jitter") {
    for (const KnownPattern& exact : lattice_patterns())
        for (const double jitter : {0.0, 0.1, 0.2})
            for (const double angle : {0.0, 0.4}) {
                const bool motif = exact.name == "honeycomb";  // two elements a cell: no lattice, told by ties alone
                if (motif && jitter > 0.05) continue;
                const KnownPattern pattern = jittered(turned(exact, angle), jitter, 5);
                INFO(pattern.name << ", jitter " << jitter);
                const Exemplar exemplar = exemplar_of(pattern.points);
                check_rings(exemplar);
                CHECK(count_usable(exemplar) >= pattern.points.size() / 5);
                CHECK_FALSE(exemplar.irregular);
                CHECK(exemplar.lattice.has_value() == !motif);
                for (const ExemplarElement& element : exemplar.elements)
                    if (element.usable) CHECK(element.ring.elements.size() == pattern.degree);
            }
}

TEST_CASE("columns and rows of a lattice say where its elements stand") {
    for (const KnownPattern& exact : lattice_patterns()) {
        if (exact.name == "honeycomb") continue;
        INFO(exact.name);
        const Exemplar exemplar = exemplar_of(jittered(turned(exact, 0.7), 0.1, 2).points);
        REQUIRE(exemplar.lattice);
        CHECK(exemplar.lattice->steps.size() == exact.degree);
        CHECK(cross(exemplar.lattice->basis[0], exemplar.lattice->basis[1]) == Approx(1 / exemplar.density).epsilon(0.05));
        const auto place = [&](const ExemplarElement& e) {
            return static_cast<double>(e.lattice[0]) * exemplar.lattice->basis[0] +
                   static_cast<double>(e.lattice[1]) * exemplar.lattice->basis[1];
        };
        const ExemplarElement& first = exemplar.elements.front();
        for (const ExemplarElement& e : exemplar.elements)
            CHECK(abs(e.position - first.position - place(e) + place(first)) < 0.5);
        for (const ExemplarElement& e : exemplar.elements)
            for (const int other : e.ring.elements) {
                const auto& o = exemplar.elements[static_cast<std::size_t>(other)].lattice;
                CHECK(std::ranges::count(exemplar.lattice->steps, std::array{o[0] - e.lattice[0], o[1] - e.lattice[1]}) ==
                      1);
            }
    }
}

TEST_CASE("an irregular pattern is never taken for a lattice") {
    for (std::uint64_t seed = 1; seed <= 24; ++seed) {
        const auto points = scattered_points(4 + static_cast<double>(seed % 6), 0.8, 800, seed);
        INFO(points.size() << " points, seed " << seed);
        const Exemplar exemplar = exemplar_of(points);
        CHECK_FALSE(exemplar.lattice.has_value());
        CHECK(exemplar.irregular);
    }
}

TEST_CASE("figures about a lattice do not depend on its rim") {
    const Exemplar square = exemplar_of(lattice_patterns().front().points);
    CHECK(square.density == Approx(1));
    CHECK(square.mean_edge == Approx(1));
    CHECK(square.largest_empty == Approx(std::sqrt(0.5)));
    CHECK(square.min_distance[0][0] == Approx(1));
    CHECK(std::isinf(square.min_distance[0][1]));
    CHECK(std::ranges::none_of(square.elements.front().ring.joined, std::identity{}));
    const Exemplar checkerboard = exemplar_of(lattice_patterns().back().points);
    CHECK(checkerboard.min_distance[0][0] == Approx(std::sqrt(2.0)));
    CHECK(checkerboard.min_distance[0][1] == Approx(1));
    CHECK(checkerboard.symbols[1].density == Approx(0.5));
    const Exemplar honeycomb = exemplar_of(lattice_patterns()[2].points);
    CHECK(honeycomb.largest_empty == Approx(1));
    CHECK(honeycomb.density == Approx(4 / (3 * std::sqrt(3.0))).epsilon(0.05));  // half cells at the rim
}

TEST_CASE("scattered points are no lattice, and their rings are Delaunay's where nothing is tied") {
    const Exemplar exemplar = exemplar_of(scattered_points(10, 0.8, 2000, 3));
    check_rings(exemplar);
    CHECK(exemplar.irregular);
    CHECK_FALSE(exemplar.lattice.has_value());
    CHECK(count_usable(exemplar) > 20);
    CHECK(exemplar.min_distance[0][0] >= 0.8);
    CHECK(exemplar.largest_empty > 0.4);
    CHECK(exemplar.largest_empty < 1.2);
}

TEST_CASE("a tile has no rim: every element is usable, with neighbours beyond the tile's edge") {
    const auto points = grid_points(4, 3, {1, 0}, {0, 1});
    const Exemplar exemplar = exemplar_of(points, {.tile = Box{{-0.5, -0.5}, {3.5, 2.5}}});
    check_rings(exemplar);
    CHECK(exemplar.originals == 12);
    CHECK(exemplar.elements.size() == 9 * 12);
    CHECK(count_usable(exemplar) == 12);
    for (std::size_t i = 0; i < exemplar.elements.size(); ++i) {
        CHECK(exemplar.elements[i].sub_id == static_cast<int>(i % 12));
        if (i < 12) CHECK(exemplar.elements[i].ring.elements.size() == 4);
    }
    CHECK(exemplar.density == Approx(1));
    CHECK(exemplar.largest_empty == Approx(std::sqrt(0.5)));
}

TEST_CASE("an edge can be flipped by hand") {
    const auto points = scattered_points(10, 0.8, 2000, 3);
    const Exemplar before = exemplar_of(points);
    std::size_t flips = 0;
    for (const auto& [a, b] : before.edges) {
        try {
            const Exemplar after = exemplar_of(points, {.flips = {{a, b}}});
            check_rings(after);
            CHECK(after.edges.size() == before.edges.size());
            CHECK(std::ranges::count(after.edges, std::pair{a, b}) == 0);
            ++flips;
        } catch (const InputError& error) {
            CHECK(std::string(error.what()).find("convex quadrilateral") != std::string::npos);
        }
    }
    CHECK(flips > before.edges.size() / 4);
}

TEST_CASE("what cannot serve as an exemplar is named, with what to do about it") {
    using Catch::Contains;
    const auto grid = grid_points(4, 4, {1, 0}, {0, 1});
    CHECK_THAT(message_of({grid.begin(), grid.begin() + 3}), Contains("example.svg: an exemplar needs at least 4 elements"));
    CHECK_THAT(message_of({grid.begin(), grid.begin() + 4}), Contains("in one line"));
    CHECK_THAT(message_of({grid.begin(), grid.begin() + 8}), Contains("no element has neighbours on all sides"));
    CHECK_THAT(message_of(std::vector<ExemplarPoint>(7, grid.front())), Contains("in one place"));
    CHECK_THAT(message_of(scattered_points(3, 0.8, 2000, 1)), Contains("only") && Contains("draw more elements"));
    CHECK_THAT(message_of(grid, {.flips = {{0, 15}}}), Contains("edge 0-15 cannot be flipped") && Contains("not joined"));
    CHECK_THAT(message_of(grid, {.flips = {{0, 16}}}), Contains("numbered from 0 to 15"));
    CHECK_THAT(message_of(grid, {.flips = {{0, 1}}}), Contains("convex quadrilateral"));
    CHECK_THAT(message_of(grid, {.tile = Box{{0, 0}, {0, 4}}}), Contains("tile has no area"));
}

}  // namespace rinceau
