#include <catch2/catch.hpp>

#include <vector>

#include "analyzer/canonical_step.h"
#include "analyzer/redrawn.h"
#include "analyzer/rule_sets.h"

using namespace rinceau;
using namespace rinceau::test;

namespace {

constexpr double still = 1e-6;

std::vector<SymmetryGroup> groups() {
    std::vector<SymmetryGroup> all;
    for (int n = 1; n <= 8; ++n) {
        all.push_back(cyclic(n));
        all.push_back(dihedral(n));
    }
    all.push_back(dihedral(5, 0.3));
    return all;
}

/// The least distance of `step` to s * other * t.
double distance_modulo(const Part& from, const Part& to, const Similarity& step, const Similarity& other) {
    double least = HUGE_VAL;
    for (const Similarity& s : from.symmetry.elements) least = std::min(least, distance(step, s * other, to.symmetry));
    return least;
}

Similarity natural_step(int direction, int spin, bool mirrored) {
    const Similarity step{polar(1, radians(15 * spin)), polar(3, radians(15 * direction)), false};
    return mirrored ? step * mirror_about_heading() : step;
}

bool is_natural(int multiple_of_15) { return multiple_of_15 % 2 == 0 || multiple_of_15 % 3 == 0; }

}  // namespace

TEST_CASE("equivalent steps have the same representative, which is one of them") {
    Random random(1);
    for (const SymmetryGroup& source : groups()) {
        const Part from = look_part(0, source);
        for (const SymmetryGroup& target : {source, cyclic(1), dihedral(3), cyclic(4)}) {
            const Part to = look_part(0, target);
            for (int trial = 0; trial < 4; ++trial) {
                const Similarity step = random_similarity(random);  // mirrored ones are glides
                const Similarity canonical = canonical_step(from, to, step, still);
                CHECK(distance_modulo(from, to, canonical, step) < 1e-9 * (1 + abs(step.translation)));
                double farthest = 0;
                for (const Similarity& s : from.symmetry.elements) {
                    for (const Similarity& t : to.symmetry.elements) {
                        farthest = std::max(farthest, distance(canonical_step(from, to, s * step * t, still), canonical));
                    }
                }
                CHECK(farthest < 1e-9 * (1 + abs(step.translation)));
            }
        }
    }
}

TEST_CASE("steps in natural directions keep their representative when they are rounded") {
    Random random(2);
    constexpr double rounding = 1e-6;
    for (const SymmetryGroup& group : groups()) {
        const Part part = look_part(0, group);
        double farthest = 0;
        for (int direction = 0; direction < 24; ++direction) {
            for (int spin = 0; spin < 24; ++spin) {
                if (!is_natural(direction) || !is_natural(spin)) continue;
                const Similarity exact = natural_step(direction, spin, direction % 2 == 1);
                Similarity shaken = exact;
                const auto shake = [&] { return random.uniform(-rounding, rounding); };
                shaken.translation += Point{shake(), shake()};
                shaken.linear += Point{shake(), shake()};
                farthest = std::max(farthest, distance(canonical_step(part, part, exact, still), canonical_step(part, part, shaken, still)));
            }
        }
        INFO(group.elements.size());
        CHECK(farthest < 10 * rounding);
    }
}

TEST_CASE("a turn on the spot is the same whatever the gauges") {
    for (const SymmetryGroup& group : groups()) {
        const Part part = look_part(0, group);
        const Similarity turn = rotate(0.2) * scale_by(1.5);
        const Similarity canonical = canonical_step(part, part, turn, still);
        CHECK(abs(canonical.translation) < still);
        CHECK(scale_of(canonical) == Approx(1.5));
        for (const Similarity& s : group.elements) CHECK(distance(canonical_step(part, part, s * turn, still), canonical) < 1e-9);
    }
}

TEST_CASE("a step to what has no direction has no angle") {
    const Part from = look_part(0, dihedral(4)), circle = look_part(1, continuous());
    Random random(3);
    const Similarity step = random_similarity(random);
    const Similarity canonical = canonical_step(from, circle, step, still);
    CHECK(canonical.linear.y == 0);
    CHECK(canonical.linear.x == Approx(scale_of(step)));
    CHECK_FALSE(canonical.mirrored);
    CHECK(distance(canonical_step(from, circle, step * rotate(1), still), canonical) < 1e-9 * (1 + abs(step.translation)));
    CHECK(abs(canonical.translation) == Approx(abs(step.translation)));
}

TEST_CASE("the step between two poses leads from one to the other, wherever they are") {
    Random random(4);
    for (int trial = 0; trial < 50; ++trial) {
        const Similarity a = random_similarity(random), b = random_similarity(random), g = random_similarity(random);
        const Similarity step = step_between(a, b);
        CHECK(distance(a * step, b) < 1e-9 * (1 + abs(b.translation)));
        CHECK(distance(step_between(g * a, g * b), step) < 1e-9 * (1 + abs(step.translation)));
    }
}
