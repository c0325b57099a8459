#include "lsystem/draw_key.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

using namespace rinceau;

/// Draws below `count` neighbouring keys.
template <class Draw>
static std::vector<double> draws(std::size_t count, std::uint64_t seed, Draw draw) {
    std::vector<double> result(count);
    for (std::size_t i = 0; i < count; ++i) result[i] = draw(key_below(root_key(seed), i));
    return result;
}

/// Sum of product a_i b_i / count.
static double mean_product(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum / static_cast<double>(a.size());
}

static double mean_power(const std::vector<double>& values, int power) {
    double sum = 0;
    for (const double value : values) sum += std::pow(value, power);
    return sum / static_cast<double>(values.size());
}

/// sum (observed - expected)^2 / expected over cells of equal probability.
template <std::size_t cells>
static double chi_square(const std::array<int, cells>& observed, std::size_t count) {
    const double expected = static_cast<double>(count) / cells;
    double sum = 0;
    for (const int n : observed) sum += (n - expected) * (n - expected) / expected;
    return sum;
}

static constexpr std::size_t many = 200'000;

/// Chi-square of 99 degrees of freedom lies within these but for 1 in 10,000 cases on either side.
static constexpr double low_chi = 53, high_chi = 159;

TEST_CASE("uniform draws fill a hundred cells evenly, in pairs of neighbouring keys and of neighbouring seeds too") {
    std::array<int, 100> single{}, neighbours{}, seeds{}, levels{};
    const std::vector<double> first = draws(many, 1, uniform_draw), other = draws(many, 2, uniform_draw);
    const auto cell = [](double a, double b) {
        return static_cast<std::size_t>(10 * a) * 10 + static_cast<std::size_t>(10 * b);
    };
    for (std::size_t i = 0; i < many; ++i) {
        REQUIRE(first[i] >= 0);
        REQUIRE(first[i] < 1);
        ++single[static_cast<std::size_t>(100 * first[i])];
        ++neighbours[cell(first[i], first[(i + 1) % many])];
        ++seeds[cell(first[i], other[i])];
        ++levels[cell(first[i], uniform_draw(key_below(key_below(root_key(1), i), 0)))];
    }
    for (const auto& observed : {single, neighbours, seeds, levels}) {
        const double chi = chi_square(observed, many);
        CHECK(chi > low_chi);
        CHECK(chi < high_chi);
    }
}

TEST_CASE("normal draws have the moments and the quantiles of a normal distribution") {
    const std::vector<double> values = draws(many, 3, normal_draw);
    // deviations of the estimates: 1, sqrt 2, sqrt 15, sqrt 96 over the root of the count
    const double root = std::sqrt(static_cast<double>(many));
    CHECK(std::abs(mean_power(values, 1)) < 4 / root);
    CHECK(std::abs(mean_power(values, 2) - 1) < 4 * std::sqrt(2.0) / root);
    CHECK(std::abs(mean_power(values, 3)) < 4 * std::sqrt(15.0) / root);
    CHECK(std::abs(mean_power(values, 4) - 3) < 4 * std::sqrt(96.0) / root);
    std::array<int, 100> cells{};
    for (const double value : values) {
        const double below = 0.5 * std::erfc(-value / std::sqrt(2.0));
        ++cells[static_cast<std::size_t>(std::min(99.0, 100 * below))];
    }
    CHECK(chi_square(cells, many) > low_chi);
    CHECK(chi_square(cells, many) < high_chi);
}

TEST_CASE("normal draws of neighbouring keys, of neighbouring seeds and of a key and one below it are uncorrelated") {
    const std::vector<double> values = draws(many, 1, normal_draw), other_seed = draws(many, 2, normal_draw);
    std::vector<double> next(values.begin() + 1, values.end());
    next.push_back(values.front());
    const std::vector<double> below = draws(many, 1, [](DrawKey key) { return normal_draw(key_below(key, 0)); });
    const double bound = 4 / std::sqrt(static_cast<double>(many));
    CHECK(std::abs(mean_product(values, next)) < bound);
    CHECK(std::abs(mean_product(values, other_seed)) < bound);
    CHECK(std::abs(mean_product(values, below)) < bound);
}

TEST_CASE("exponential and normal draws agree with the library's logarithm and cosine to 1e-14") {
    const double two_pi = 2 * std::acos(-1.0);
    for (std::uint64_t i = 0; i < 100'000; ++i) {
        const DrawKey key = key_below(root_key(9), i);
        const double exact = -std::log(1 - uniform_draw(key));
        CHECK(std::abs(exponential_draw(key) - exact) <= 1e-14 * std::max(1.0, exact));
        const double normal = std::sqrt(2 * exact) * std::cos(two_pi * uniform_draw(key_below(key, 0)));
        CHECK(std::abs(normal_draw(key) - normal) < 1e-14);
    }
}

TEST_CASE("draws are the same bits on every machine") {
    CHECK(root_key(1) == 13830413928045401970ULL);
    CHECK(uniform_draw(key_below(root_key(1), 0)) == 0x1.571565a7b500cp-2);
    CHECK(normal_draw(key_below(root_key(1), 0)) == 0x1.19f6f51a4b946p-1);
    CHECK(exponential_draw(key_below(root_key(1), 0)) == 0x1.a1d334384c8d8p-2);
}

TEST_CASE("keys of many places differ") {
    std::set<DrawKey> keys;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        for (std::uint64_t a = 0; a < 50; ++a) {
            for (std::uint64_t b = 0; b < 50; ++b) keys.insert(key_below(key_below(root_key(seed), a), b));
        }
    }
    CHECK(keys.size() == 20 * 50 * 50);
}
