#include <catch2/catch.hpp>

#include "derivation_world.h"

using namespace rinceau;

namespace {

const std::string stone = "shape stone = box\nshape part = box\nshape after = box\n";

std::string one_obstacle(const std::string& place) { return stone + "axiom nearest " + place + " I(\"stone\")\n"; }

}  // namespace

TEST_CASE("the parts of a Lock stand all or none") {
    const std::string rules =
        "axiom nearest 5 5 0 A\nA ~ Lock{ Part | T(2,0,0) Part | T(0,2,0) Part } T(0,-3,0) I(\"after\")\n"
        "Part ~ S(0.8,0.8,0.8) IC(\"part\")\n";
    const SurfacePattern all = grown(one_obstacle("1 1 0") + rules, plane_world());
    CHECK(count_of(all, "part") == 3);
    CHECK(count_of(all, "after") == 1);
    const SurfacePattern none = grown(one_obstacle("5 7 0") + rules, plane_world());
    CHECK(count_of(none, "part") == 0);
    CHECK(count_of(none, "after") == 0);
    CHECK(none.counts.locks_given_up == 1);
}

TEST_CASE("a Lock that is given up leaves nothing behind") {
    // the second Lock would collide with the first one's parts if they were still there
    const std::string text = one_obstacle("5 7 0") + R"(
axiom nearest 5 5 0 A
axiom nearest 5 5 0 B
A ~ Lock{ Set("k",3) Row(0) | Line(0) LineSeg(1,0.1) | T(0,2,0) IC("part") }
B ~ Lock{ Row(0) }
Row(n) : n < 3 ~ [T(n,0,0) S(0.5,0.5,0.5) IC("part")] Row(n+1)
)";
    const SurfacePattern pattern = grown(text, plane_world());
    CHECK(count_of(pattern, "part") == 3);
    CHECK(pattern.lines.empty());
    CHECK(pattern.counts.locks_given_up == 1);
    CHECK(pattern.counts.collisions_avoided == 0);
    for (const PatternShape& shape : pattern.placed) CHECK(shape.attributes.empty());
}

TEST_CASE("a line that a Lock has lengthened is as long as before when the Lock is given up") {
    const std::string text = one_obstacle("5 7 0") + R"(
axiom nearest 5 5 0 Line(0) LineSeg(1,0.1) [Lock{ LineSeg(1,0.1) LineSeg(1,0.1) | T(-1,2,0) IC("part") }] LineSeg(0.5,0.1)
)";
    const SurfacePattern pattern = grown(text, plane_world());
    REQUIRE(pattern.lines.size() == 1);
    CHECK(pattern.lines[0].segments == 2);
    CHECK(abs(pattern.lines[0].points.back() - SpacePoint{6.5, 5, 0}) < 1e-9);
    CHECK(pattern.lines[0].widths.size() == pattern.lines[0].points.size());
}

TEST_CASE("the parts of a Lock are tested against what is outside of it, not against each other") {
    const std::string text = one_obstacle("1 1 0") +
                             "axiom nearest 5 5 0 Lock{ IC(\"part\") | T(0.5,0,0) IC(\"part\") } IC(\"after\")\n"
                             "axiom nearest 5 5 0 IC(\"after\")\n";
    const SurfacePattern pattern = grown(text, plane_world());
    CHECK(count_of(pattern, "part") == 2);
    CHECK(count_of(pattern, "after") == 0);
}

TEST_CASE("a Lock stands clear of the Lock that it comes from") {
    const auto row = [](const std::string& step) {
        return grown(stone + "axiom nearest 2 5 0 A(0)\nA(n) : n < 3 ~ Lock{ IC(\"part\") } T(" + step + ",0,0) A(n+1)\n",
                     plane_world());
    };
    CHECK(count_of(row("1.1"), "part") == 3);
    CHECK(count_of(row("0.8"), "part") == 1);
}

TEST_CASE("plain instances in a Lock are tested too, and its symbols are derived at once") {
    const std::string text = one_obstacle("8.6 5 0") +
                             "axiom nearest 5 5 0 Lock{ Row(0) } I(\"after\")\n"
                             "Row(n) : n < 4 ~ [T(n,0,0) S(0.5,0.5,0.5) I(\"part\")] Row(n+1)\n";
    const SurfacePattern pattern = grown(text, plane_world());
    CHECK(count_of(pattern, "part") == 0);
    CHECK(count_of(pattern, "after") == 0);
}

TEST_CASE("a Lock over the surface's border is given up, one inside another decides with it") {
    CHECK(count_of(
              grown(one_obstacle("1 1 0") + "axiom nearest 5 5 0 Lock{ I(\"part\") | T(9,0,0) I(\"part\") }", plane_world()),
              "part") == 0);
    const std::string nested =
        "axiom nearest 5 5 0 Lock{ T(0,-2,0) IC(\"part\") | Lock{ IC(\"part\") | T(0,2,0) IC(\"part\") } }";
    CHECK(count_of(grown(one_obstacle("1 1 0") + nested, plane_world()), "part") == 3);
    CHECK(count_of(grown(one_obstacle("5 7 0") + nested, plane_world()), "part") == 0);
}

TEST_CASE("a Lock whose symbols do not end ends the derivation with its name") {
    const SurfacePattern pattern =
        grown(one_obstacle("1 1 0") + "axiom nearest 5 5 0 Lock{ Rest }\nRest ~ Rz(10) Rest\n", plane_world());
    CHECK_FALSE(pattern.complete);
    CHECK(pattern.limit.find("Lock") != std::string::npos);
    CHECK(pattern.limit.find("Rest") != std::string::npos);
    CHECK(count_of(pattern, "stone") == 1);
}
