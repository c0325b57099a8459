// The grammars of the figures of Stava et al. 2010, with the printed parameters, against closed forms.

#include <catch2/catch.hpp>
#include <cmath>

#include "lsystem/expression_functions.h"
#include "lsystem/grammar_text.h"
#include "lsystem/interpret.h"

using namespace rinceau;

static std::vector<Placement> placed(const std::string& body) {
    return interpret(parse_grammar("lsystem 1\n" + body + "\nterminal A: path \"M0 0L0-1\"\n"));
}

/// T = +(turn) f(advance) *(scale) +(spin), angles in degrees.
static Similarity step(double turn, double advance, double scale, double spin) {
    return rotate(radians(turn)) * translate({0, advance}) * scale_by(scale) * rotate(radians(spin));
}

static void check_pose(const Similarity& found, const Similarity& expected, double tolerance) {
    CHECK(abs(found.linear - expected.linear) < tolerance);
    CHECK(abs(found.translation - expected.translation) < tolerance);
}

TEST_CASE("figure 1: the branching structure R(3) has 15 elements in four levels") {
    const std::string rule =
        "R(m) : m > 0 -> [A] [-(17) f(64) *(0.8) -(3) R(m-1)] [+(7) f(181) *(0.6) +(23) R(m-1)]\n"
        "R(m) : m == 0 -> [A]\n";
    const auto placements = placed("axiom: R(3)\n" + rule);
    REQUIRE(placements.size() == 15);
    // preorder: the left child follows its parent, the right one the left one's whole tree
    const Similarity left = step(-17, 64, 0.8, -3);
    const Similarity right = step(7, 181, 0.6, 23);
    check_pose(placements[0].pose, {}, 1e-12);
    check_pose(placements[1].pose, left, 1e-9);
    check_pose(placements[8].pose, right, 1e-9);
    check_pose(placements[14].pose, right * right * right, 1e-9);
    check_pose(placements[6].pose, left * right * left, 1e-9);
    CHECK(placed("axiom: R(10)\n" + rule).size() == 2047);
}

TEST_CASE("figure 5: angles that grow linearly with m, t(m) = t0 + tDelta m") {
    const auto placements = placed(
        "axiom: P(3)\n"
        "P(m) : m > 0 -> [A] +(60+10*m) f(1) +(-50+10*m) P(m-1)\n"
        "P(m) : m == 0 -> [A]\n");
    REQUIRE(placements.size() == 4);
    Similarity pose;
    for (int i = 0; i < 4; ++i) {
        check_pose(placements[static_cast<std::size_t>(i)].pose, pose, 1e-12);
        const int m = 3 - i;  // counts down: P(3) uses t(3) first
        pose = pose * step(60 + 10 * m, 1, 1, -50 + 10 * m);
    }
}

TEST_CASE("figure 8: five elements from P(4) with t0 = (7, 50, 1, 7)") {
    const auto placements = placed(
        "axiom: P(4)\n"
        "P(m) : m > 0 -> [A] +(7) f(50) *(1) +(7) P(m-1)\n"
        "P(m) : m == 0 -> [A]\n");
    REQUIRE(placements.size() == 5);
    // a chain of equal steps lies on a circle: 50 = 2 r sin(7 degrees)
    const double radius = 25 / sine_of_degrees(7);
    const Point center{-radius, 0};
    for (std::size_t i = 0; i < placements.size(); ++i) {
        const double turned = 14.0 * static_cast<double>(i);
        CHECK(abs(placements[i].pose.translation - (center + polar(radius, radians(turned)))) < 1e-9);
        CHECK(std::abs(arg(placements[i].pose.linear) - radians(turned)) < 1e-12);
    }
}

TEST_CASE("figure 9: the helix of 336 elements is a logarithmic spiral") {
    const auto placements = placed("axiom: P(336)\nP(m) : m > 0 -> A f(27.5) *(0.993) +(8.5) P(m-1)\n");
    REQUIRE(placements.size() == 336);
    const Complex ratio = polar(0.993, radians(8.5));
    Complex power{1, 0};
    for (const Placement& placement : placements) {
        // geometric series: sum of 27.5 i ratio^k
        const Point place = Complex{0, 27.5} * ((Complex{1, 0} - power) / (Complex{1, 0} - ratio));
        check_pose(placement.pose, {power, place}, 1e-10);
        power = power * ratio;
    }
}

TEST_CASE("figure 10: the facade of 72 windows is a grid of grids") {
    const auto placements = placed(
        "axiom: P3(2)\n"
        "P0(m) : m > 0 -> [A] f(13) P0(m-1)\n"
        "P1(m) : m > 0 -> [P0(3)] +(90) f(10) -(90) P1(m-1)\n"
        "P2(m) : m > 0 -> [P1(4)] +(90) f(52) -(90) P2(m-1)\n"
        "P3(m) : m > 0 -> [P2(3)] f(51) P3(m-1)\n");
    REQUIRE(placements.size() == 72);
    std::size_t i = 0;
    for (int block_row = 0; block_row < 2; ++block_row) {
        for (int block = 0; block < 3; ++block) {
            for (int column = 0; column < 4; ++column) {
                for (int row = 0; row < 3; ++row, ++i) {
                    check_pose(placements[i].pose, translate({-52.0 * block - 10.0 * column, 51.0 * block_row + 13.0 * row}),
                               1e-10);
                }
            }
        }
    }
}
