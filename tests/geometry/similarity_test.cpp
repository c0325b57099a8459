#include <catch2/catch.hpp>

#include "geometry/affine.h"
#include "geometry/random.h"
#include "geometry/similarity.h"

using namespace rinceau;

static Similarity random_similarity(Random& random) {
    return {polar(random.uniform(0.1, 5), random.uniform(-pi, pi)), {random.uniform(-9, 9), random.uniform(-9, 9)},
            random.below(2) == 1};
}

TEST_CASE("a similarity and its inverse give the identity, mirrored or not") {
    Random random(7);
    for (int i = 0; i < 200; ++i) {
        const Similarity g = random_similarity(random);
        const Point p{random.uniform(-9, 9), random.uniform(-9, 9)};
        CHECK(abs(apply(inverse(g), apply(g, p)) - p) < 1e-12);
        CHECK(abs(apply(g * inverse(g), p) - p) < 1e-12);
    }
}

TEST_CASE("a product of similarities applies the right one first") {
    Random random(8);
    for (int i = 0; i < 200; ++i) {
        const Similarity g = random_similarity(random);
        const Similarity h = random_similarity(random);
        const Point p{random.uniform(-9, 9), random.uniform(-9, 9)};
        CHECK(abs(apply(g * h, p) - apply(g, apply(h, p))) < 1e-11);
        CHECK(abs(apply(to_affine(g), p) - apply(g, p)) < 1e-12);
    }
}
