// The field of distances and the places that are drawn from it.

#include <catch2/catch.hpp>

#include "tests/growth/aggregate_shapes.h"
#include "geometry/polygon.h"
#include "growth/aggregate/gap_sampler.h"

namespace rinceau {
namespace {

std::vector<Region> scattered_outlines(int count, double side) {
    const std::vector<ExclusiveRegion> regions = star_bar_and_bow();
    Random random(11);
    std::vector<Region> outlines;
    for (int i = 0; i < count; ++i) {
        const Similarity pose{polar(1, random.uniform(0, two_pi)), {random.uniform(0, side), random.uniform(0, side)}};
        outlines.push_back(outline_of(regions, {i % 3, pose}));
    }
    return outlines;
}

CellMask random_mask(int columns, int rows, Random& random) {
    CellMask mask{columns, rows, {}};
    for (int i = 0; i < columns * rows; ++i) mask.marked.push_back(random.below(40) == 0);
    return mask;
}

}  // namespace

TEST_CASE("distances to marked cells are those of brute force, also around a tile and with oblong cells") {
    Random random(5);
    for (const bool wrapped : {false, true})
        for (const CellSize cell : {CellSize{1, 1}, CellSize{2, 3}}) {
            const CellMask mask = random_mask(23, 17, random);
            const std::vector<float> distances = distances_to_marked(mask, cell, wrapped);
            for (int i = 0; i < 23 * 17; ++i) {
                double nearest = 1e9;
                for (int k = 0; k < 23 * 17; ++k) {
                    if (!mask.marked[static_cast<std::size_t>(k)]) continue;
                    int across = std::abs(i % 23 - k % 23), up = std::abs(i / 23 - k / 23);
                    if (wrapped) across = std::min(across, 23 - across), up = std::min(up, 17 - up);
                    nearest = std::min(nearest, std::hypot(across * cell.x, up * cell.y));
                }
                REQUIRE(distances[static_cast<std::size_t>(i)] == Approx(nearest));
            }
        }
    const std::vector<float> nothing = distances_to_marked({4, 3, std::vector<std::uint8_t>(12, 0)}, {1, 1});
    CHECK(std::ranges::all_of(nothing, [](float d) { return std::isinf(d); }));
}

TEST_CASE("a field that grows region by region is the field of all of them") {
    for (const bool tiled : {false, true}) {
        const PackDomain domain{.box = {{0, 0}, {400, 400}}, .tiled = tiled};
        DistanceField one_by_one(domain, 3, 100'000), at_once(domain, 3, 100'000);
        const std::vector<Region> outlines = scattered_outlines(25, 400);
        for (const Region& outline : outlines) one_by_one.add(outline);
        at_once.add_all(outlines);
        double worst = 0;
        for (int row = 0; row < at_once.rows(); ++row)
            for (int column = 0; column < at_once.columns(); ++column)
                // Inside, regions that lie over one another make one in the field of all.
                if (at_once.value(column, row) > 0)
                    worst = std::max<double>(worst, std::abs(at_once.value(column, row) - one_by_one.value(column, row)));
        CHECK(worst <= 1e-4);
    }
}

TEST_CASE("field values are the distances to what is there, to within a cell") {
    const Region region{box_ring(0, 0, 300, 200), box_ring(100, 50, 80, 60)};
    DistanceField field({.box = {{-50, -50}, {400, 300}}, .region = region}, 2, 100'000);
    const Region bar{box_ring(20, 20, 50, 9)};
    field.add(bar);
    Random random(3);
    for (int i = 0; i < 500; ++i) {
        const Point p{random.uniform(0, 300), random.uniform(0, 200)};
        double nearest = 1e9;
        bool free = true;
        for (const Region& lines : {region, bar})
            for (const auto& ring : lines)
                for (std::size_t k = 0; k < ring.size(); ++k)
                    nearest = std::min(nearest, distance_to_segment(p, ring[k], ring[(k + 1) % ring.size()]));
        free = !inside_evenodd(region[1], p) && !inside_evenodd(bar[0], p);
        REQUIRE(field.at(p) == Approx(free ? nearest : -nearest).margin(field.step()));
        if (free && nearest > 4 * field.step())
            REQUIRE(field.at(p + 1e-3 * field.step() * field.uphill(p)) > field.at(p) - 1e-9);
    }
    CHECK(field.at({-20, 100}) < 0);
    CHECK(field.uphill({-20, 100}).x > 0.9);
}

TEST_CASE("gaps are drawn with the 16th power of their depth") {
    DistanceField field({.box = {{0, 0}, {120, 90}}}, 5, 10'000);
    GapSampler sampler(field, 3);
    const CellWindow changed = field.add({box_ring(10, 10, 60, 40)});
    sampler.update(field, changed);
    const int cells = field.columns() * field.rows();
    std::vector<double> expected, drawn(static_cast<std::size_t>(cells), 0.0);
    double sum = 0;
    for (int i = 0; i < cells; ++i) {
        const double value = field.value(i % field.columns(), i / field.columns());
        expected.push_back(value > 3 ? std::pow(value, 16) : 0);
        sum += expected.back();
    }
    Random random(2);
    constexpr int draws = 40'000;
    for (int i = 0; i < draws; ++i) {
        const std::optional<Point> p = sampler.draw(field, random);
        REQUIRE(p);
        const Point cell = *p - field.corner(0, 0);
        const int column = static_cast<int>(cell.x / field.cell().x), row = static_cast<int>(cell.y / field.cell().y);
        ++drawn[static_cast<std::size_t>(row * field.columns() + column)];
    }
    // Chi-square over the cells that are expected often enough.
    double chi_square = 0;
    int freedom = -1;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const double mean = draws * expected[i] / sum;
        if (expected[i] <= 0) REQUIRE(drawn[i] == 0);
        if (mean < 5) continue;
        chi_square += (drawn[i] - mean) * (drawn[i] - mean) / mean;
        ++freedom;
    }
    REQUIRE(freedom > 10);
    CHECK(chi_square < freedom + 4 * std::sqrt(2.0 * freedom));  // four standard deviations
    // Nothing is drawn where no gap is left.
    sampler.update(field, field.add({box_ring(-10, -10, 200, 200)}));
    CHECK_FALSE(sampler.draw(field, random));
}

}  // namespace rinceau
