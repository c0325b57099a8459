#include <catch2/catch.hpp>

#include "derivation_world.h"

using namespace rinceau;

namespace {

std::string names_of(const SurfacePattern& pattern) {
    std::string names;
    for (const PatternShape& shape : pattern.placed) names += pattern.shapes[static_cast<std::size_t>(shape.shape)].name;
    return names;
}

bool same(const SurfacePattern& a, const SurfacePattern& b) {
    if (a.placed.size() != b.placed.size() || a.lines.size() != b.lines.size()) return false;
    for (std::size_t i = 0; i < a.placed.size(); ++i)
        if (a.placed[i].position != b.placed[i].position || a.placed[i].axes != b.placed[i].axes ||
            a.placed[i].size != b.placed[i].size || a.placed[i].rule != b.placed[i].rule)
            return false;
    for (std::size_t i = 0; i < a.lines.size(); ++i)
        if (a.lines[i].points != b.lines[i].points) return false;
    return true;
}

const std::string shapes = "shape a = box\nshape b = box\nshape c = box\n";

const std::string bush = R"(
shape leaf = box
axiom scatter 3 Twig(0)
Twig(n) : n < 6 ~ T(rand(0.2,0.5),0,0) Rz(rand(-40,40)) [Leaf] Twig(n+1) : 2
Twig(n) : n < 6 ~ [Rz(30) T(0.3,0,0) Twig(n+1)] [Rz(-30) T(0.3,0,0) Twig(n+1)] : 1
Leaf ~ S(0.1,0.05,0.05) IC("leaf") @ -1
)";

}  // namespace

TEST_CASE("the symbol whose rule has the highest priority goes first") {
    // two things in each rule, so that none is derived at once
    const std::string rules = "A ~ I(\"a\") I(\"a\") @ -1\nB ~ I(\"b\") I(\"b\") @ 5\nC ~ I(\"c\") I(\"c\")\n";
    CHECK(names_of(grown(shapes + rules + "axiom nearest 5 5 0 A B C A", plane_world())) == "bbccaaaa");
}

TEST_CASE("leaves wait until all stems stand") {
    const SurfacePattern pattern = grown(bush, plane_world());
    CHECK(pattern.placed.size() > 10);
    int depth = 0;
    for (const PatternShape& shape : pattern.placed) depth = std::max(depth, shape.depth);
    CHECK(depth > 5);
    // a leaf is of the rule with the lowest priority, so nothing else was applied after the first of them
    const std::string order =
        "shape s = box\nshape l = box\naxiom nearest 5 5 0 Stem(0)\n"
        "Stem(n) : n < 4 ~ Piece Leaf T(1,0,0) Stem(n+1)\nPiece ~ I(\"s\")\nLeaf ~ I(\"l\") @ -1\n";
    CHECK(names_of(grown(order, plane_world())) == "ssssllll");
}

TEST_CASE("rules of one symbol with different priorities take their turns") {
    const std::string rules =
        "A(n) : n == 0 ~ I(\"a\") I(\"a\") @ 2\nA(n) : n == 1 ~ I(\"b\") I(\"b\") @ -2\nC ~ I(\"c\") I(\"c\")\n";
    CHECK(names_of(grown(shapes + rules + "axiom nearest 5 5 0 A(1) C A(0)", plane_world())) == "aaccbb");
}

TEST_CASE("breadth first goes level by level, depth first down each way") {
    const std::string rules =
        "X(n) : n < 2 ~ Put(n) X(n+1) X(n+1)\nX(n) : n == 2 ~ Put(n)\n"
        "Put(n) : n == 0 ~ I(\"a\")\nPut(n) : n == 1 ~ I(\"b\")\nPut(n) : n == 2 ~ I(\"c\")\naxiom nearest 5 5 0 X(0)\n";
    CHECK(names_of(grown(shapes + rules, plane_world())) == "abbcccc");
    CHECK(names_of(grown(shapes + rules + "option order = depth\n", plane_world())) == "abccbcc");
}

TEST_CASE("later axioms begin when nothing of the earlier ones waits") {
    const std::string rules =
        "A(n) : n < 3 ~ Put A(n+1)\nPut ~ I(\"a\")\naxiom nearest 5 5 0 A(0)\naxiom nearest 5 5 0 I(\"b\")\n";
    CHECK(names_of(grown(shapes + rules, plane_world())) == "aaab");
}

TEST_CASE("rules are chosen by their weights, and one alone may choose nothing") {
    const std::string begin = shapes + "axiom scatter 4000 A\n";
    const SurfacePattern shared = grown(begin + "A ~ I(\"a\") : 3\nA ~ I(\"b\") : 1\n", plane_world());
    CHECK(shared.placed.size() == 4000);
    CHECK(count_of(shared, "a") == Approx(3000).margin(120));
    const SurfacePattern alone = grown(begin + "A ~ I(\"a\") : 0.3\n", plane_world());
    CHECK(count_of(alone, "a") == Approx(1200).margin(120));
    // the other rule's condition does not hold: this one is alone
    const SurfacePattern left = grown(begin + "A ~ I(\"a\") : 0.3\nA : 1 == 2 ~ I(\"b\") : 0.7\n", plane_world());
    CHECK(count_of(left, "a") == Approx(1200).margin(120));
    CHECK(count_of(left, "b") == 0);
}

TEST_CASE("a seed gives one pattern, another seed another one, and steps do not matter") {
    const SurfaceWorld world = bare_world(torus_triangles(32, 16, 2, 0.8));
    const SurfacePattern once = grown(bush, world), again = grown(bush, world);
    CHECK(same(once, again));
    ShapeDerivationOptions options;
    options.seed = 2;
    CHECK_FALSE(same(once, grown(bush, world, options)));

    SurfaceWorld with_shapes = world;
    with_shapes.shapes.push_back(test_shape("leaf"));
    ShapeDerivation derivation(parse_shape_grammar(bush), with_shapes);
    int steps = 0;
    for (; !derivation.done(); ++steps) {
        derivation.step(7);
        CHECK(derivation.pattern().complete == derivation.done());
    }
    CHECK(steps > 5);
    CHECK(same(once, derivation.pattern()));
}

TEST_CASE("a derivation without end stops at its bounds and names the rule") {
    const std::string endless =
        "shape a = box\naxiom nearest 5 5 0 More\n\nMore ~ S(0.1,0.1,0.1) I(\"a\") [Rz(50) T(0.01,0,0) More] [More]\n";
    ShapeDerivationOptions options;
    options.max_shapes = 5000;
    const SurfacePattern many = grown(endless, plane_world(), options);
    CHECK_FALSE(many.complete);
    CHECK(many.placed.size() > 1000);
    CHECK(many.placed.size() <= 5002);
    CHECK(many.limit.find("'More' of line 4") != std::string::npos);
    CHECK(many.limit.find("5000 shapes") != std::string::npos);

    options = {};
    options.max_rules = 300;
    const SurfacePattern few =
        grown("shape a = box\naxiom nearest 5 5 0 Turn\nTurn ~ Rz(10) Turn\n", plane_world(), options);
    CHECK_FALSE(few.complete);
    CHECK(few.counts.rules_applied == 300);
    CHECK(few.limit.find("300 rules") != std::string::npos);
    options.max_rules = 20'000'000;
    options.max_seconds = 0.05;
    CHECK(grown("shape a = box\naxiom nearest 5 5 0 Turn\nTurn ~ Rz(10) Turn\n", plane_world(), options)
              .limit.find("0.05 seconds") != std::string::npos);
}

TEST_CASE("rules that take long do not make a derivation late: it looks at the clock between any two of them") {
    const SurfaceWorld world = bare_world(torus_triangles(24, 12, 2, 0.7));
    ShapeDerivationOptions options;
    options.max_seconds = 0.01;
    const SurfacePattern round = grown("axiom vertex 0 Far\nFar ~ T(1e9,0,0) Far\n", world, options);
    CHECK(round.limit.find("0.01 seconds") != std::string::npos);
    CHECK(round.counts.rules_applied < 100);
}

TEST_CASE("progress may cancel, and shares rise to the end") {
    SurfaceWorld world = plane_world();
    world.shapes.push_back(test_shape("leaf"));
    struct Cancelled {};
    CHECK_THROWS_AS(derive_shapes(parse_shape_grammar(bush), world, {}, [](std::string_view, double) { throw Cancelled(); }),
                    Cancelled);
    derive_shapes(parse_shape_grammar(bush), world, {}, [](std::string_view stage, double share) {
        CHECK(stage == "growing");
        CHECK(share >= 0);
        CHECK(share <= 1);
    });
}

TEST_CASE("a ring through a chart closes on a curved surface, one walked from place to place does not") {
    const std::string ring = R"(
shape start = box
shape pearl = box
param n = 12
param r = 0.5
Ring(i) : i < n ~ [Rz(360*i/n) T(r,0,0) Rz(90) S(0.01,0.01,0.01) I("pearl")] Ring(i+1)
axiom vertex 40 Chart{ Ring(0) } I("start")
)";
    const SurfaceWorld world = bare_world(sphere_triangles(4));
    const SurfacePattern pattern = grown(ring, world);
    REQUIRE(pattern.placed.size() == 13);
    std::vector<SpacePoint> pearls;
    SpacePoint middle;
    for (const PatternShape& shape : pattern.placed) {
        const bool pearl = pattern.shapes[static_cast<std::size_t>(shape.shape)].name == "pearl";
        if (pearl)
            pearls.push_back(shape.position);
        else
            middle = shape.position;
    }
    REQUIRE(pearls.size() == 12);
    const double spacing = 2 * std::sin(0.5) * std::sin(pi / 12);
    for (std::size_t i = 0; i < 12; ++i) {
        CHECK(abs(pearls[i] - pearls[(i + 1) % 12]) == Approx(spacing).epsilon(0.02));
        CHECK(std::acos(dot(unit(pearls[i]), unit(middle))) == Approx(0.5).epsilon(0.01));
    }
}

TEST_CASE("moves in a chart are one: there and back is the place it began, whatever lies between") {
    const std::string text = R"(
shape dot = box
axiom vertex 40 I("dot") Chart{ Way }
Way ~ T(0.6,0.1,0) Rz(90) T(0.4,0,0) Rz(90) T(0.6,0,0) Rz(90) T(0.3,0,0) Rz(90) T(0,-0.2,0) I("dot") @ 1
)";
    const SurfaceWorld world = bare_world(sphere_triangles(4));
    const SurfacePattern pattern = grown(text, world);
    REQUIRE(pattern.placed.size() == 2);
    CHECK(abs(pattern.placed[0].position - pattern.placed[1].position) < 1e-9);
    CHECK(abs(pattern.placed[0].axes[0] - pattern.placed[1].axes[0]) < 1e-2);  // a chart is linear in each face
}
