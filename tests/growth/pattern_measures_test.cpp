// Measures of arrangements on points whose figures are known.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "geometry/random.h"
#include "growth/measure/empty_circle.h"
#include "growth/measure/pair_correlation.h"
#include "growth/measure/ring_fit.h"

using namespace rinceau;

namespace {

const Box square{{0, 0}, {40, 40}};

std::vector<Point> strewn(int count, std::uint64_t seed) {
    Random random(seed);
    std::vector<Point> points;
    for (int i = 0; i < count; ++i) {
        const double x = random.uniform(0, 40);
        points.push_back({x, random.uniform(0, 40)});
    }
    return points;
}

std::vector<Point> lattice(int columns, int rows) {
    std::vector<Point> points;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) points.push_back({1.0 * column, 1.0 * row});
    return points;
}

PointPattern in_square(std::vector<Point> points) {
    std::vector<int> symbols(points.size());
    PointPattern pattern = tiled_pattern(std::move(points), std::move(symbols), square);
    pattern.tile.reset();
    return pattern;
}

PointPattern one_kind(const std::vector<Point>& points) { return pattern_of(points, std::vector<int>(points.size()), 1); }

double mean(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

}  // namespace

TEST_CASE("Points strewn by chance have pair correlation 1, in a window and on a tile") {
    PointPattern pattern = in_square(strewn(3000, 1));
    const std::vector<double> radii = correlation_radii(pattern, 1);
    CHECK(radii.size() == 40);
    CHECK(mean(pair_correlation(pattern, 1, radii, 0.15).of_pair[0]) == Approx(1).margin(0.02));
    pattern.tile = square;
    CHECK(mean(pair_correlation(pattern, 1, radii, 0.15).of_pair[0]) == Approx(1).margin(0.02));
}

TEST_CASE("Kinds that were drawn by chance do not know of each other") {
    PointPattern pattern = in_square(strewn(3000, 2));
    for (std::size_t i = 0; i < pattern.symbols.size(); ++i) pattern.symbols[i] = i % 3 == 0 ? 1 : 0;
    const PairCorrelation g = pair_correlation(pattern, 2, correlation_radii(pattern, 1), 0.15);
    CHECK(g.shares[1] == Approx(1.0 / 3));
    for (const auto& values : g.of_pair) CHECK(mean(values) == Approx(1).margin(0.04));
    CHECK(mean(g.of_pair[1]) == Approx(mean(g.of_pair[2])));
}

TEST_CASE("A lattice has peaks at its steps and nothing between") {
    const PointPattern pattern = tiled_pattern(lattice(40, 40), std::vector<int>(1600), square);
    const std::vector<double> radii{0.7, 1.0, 1.2, std::sqrt(2.0)};
    const std::vector<double> g = pair_correlation(pattern, 1, {radii}, 0.1).of_pair[0];
    CHECK(g[0] == 0);
    CHECK(g[2] == 0);
    // Four neighbours on a ring of circumference 2 pi, the kernel's height 0.75 / 0.1.
    CHECK(g[1] == Approx(4 * 7.5 / (2 * 3.14159265358979) * 1600 / 1599));
}

TEST_CASE("Patterns of one making are near to each other, of another far") {
    const PointPattern a = in_square(strewn(1000, 5)), b = in_square(strewn(1000, 6));
    std::vector<Point> regular;
    Random random(7);
    for (const Point p : lattice(32, 32)) {
        const double x = random.uniform(-0.2, 0.2);
        regular.push_back(1.25 * (p + Point{0.5 + x, 0.5 + random.uniform(-0.2, 0.2)}));
    }
    const double spacing = 1.25;
    CHECK(pair_distance(a, b, 1, spacing) < 0.1);
    CHECK(pair_spread(a, 1, spacing) < 0.2);
    CHECK(pair_distance(in_square(regular), a, 1, spacing) > 0.2);
    CHECK(pair_distance(a, a, 1, spacing) == 0);
}

TEST_CASE("What a lattice covers is one cell for each point, whatever its shape") {
    CHECK(density(one_kind(lattice(12, 12))) == Approx(1).epsilon(0.01));
    CHECK(density(one_kind(lattice(30, 4))) == Approx(1).epsilon(0.02));
    std::vector<Point> disc, hollow;
    for (const Point p : lattice(41, 41)) {
        const double away = abs(p - Point{20, 20});
        if (away <= 20) disc.push_back(p);
        if (away <= 20 && away > 3.2) hollow.push_back(p);
    }
    CHECK(density(one_kind(disc)) == Approx(1).epsilon(0.02));
    // A hole does not shrink what is covered: it makes it less dense.
    CHECK(density(one_kind(hollow)) ==
          Approx(static_cast<double>(hollow.size()) / static_cast<double>(disc.size())).epsilon(0.02));
}

TEST_CASE("The largest empty circle of a lattice is that of a cell, and a point taken out is found") {
    std::vector<Point> points = lattice(20, 20);
    CHECK(largest_empty_circle(one_kind(points), 0).radius == Approx(std::sqrt(0.5)));
    const auto taken = std::find(points.begin(), points.end(), Point{9, 12});
    points.erase(taken);
    const EmptyCircle hole = largest_empty_circle(one_kind(points), 1);
    CHECK(hole.radius == Approx(1));
    CHECK(abs(hole.center - Point{9, 12}) < 1e-6);
    // Of an edge's notch nothing is said.
    points = lattice(20, 20);
    points.erase(std::find(points.begin(), points.end(), Point{0, 12}));
    CHECK(largest_empty_circle(one_kind(points), 1).radius == Approx(std::sqrt(0.5)));
}

TEST_CASE("The distance of degree histograms is the share that must change") {
    CHECK(degree_distance({0, 0, 1}, {0, 0, 1}) == 0);
    CHECK(degree_distance({0, 0, 1}, {0, 1}) == 1);
    CHECK(degree_distance({0, 0.25, 0.75}, {0, 0, 1}) == Approx(0.25));
}

TEST_CASE("The fit of rings counts what is longer, turned aside, missing and too many") {
    Exemplar exemplar;
    exemplar.mean_edge = 2;
    ExemplarElement cross;
    cross.ring = {{1, 2, 3, 4}, {{2, 0}, {0, 2}, {-2, 0}, {0, -2}}, {false, false, false, false}};
    cross.usable = true;
    exemplar.elements = {cross};
    // An element turned by 90 degrees whose neighbours stand: right, one too far by a tenth, one aside, one where none
    // belongs.
    const std::vector<ArrangedElement> elements{
        {0, {0, 0}, 1.5707963267948966}, {0, {2, 0}, 0}, {0, {0, 2.2}, 0}, {0, {-2, 0.3}, 0}, {0, {4, 4}, 0}};
    const std::vector<std::pair<int, int>> edges{{0, 1}, {0, 2}, {0, 3}, {0, 4}};
    const RingFit fit = ring_fit(exemplar, elements, edges, {true, false, false, false, false});
    const double aside = std::hypot(2, 0.3) - 2;
    CHECK(fit.right_degrees == 1);
    CHECK(fit.degrees == DegreeHistogram{0, 0, 0, 0, 1});
    CHECK(fit.defects == 1);
    CHECK(fit.spacing_error == Approx(std::sqrt((0.2 * 0.2 + aside * aside) / 3) / 2));
    CHECK(fit.largest_spacing_error == Approx(0.1));
    CHECK(fit.ring_error == Approx(std::sqrt((0.2 * 0.2 + 0.3 * 0.3) / 3) / 2));
    CHECK(degree_distance(fit.degrees, degree_histogram(exemplar)) == 0);
}
