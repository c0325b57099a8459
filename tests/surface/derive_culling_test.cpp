#include <catch2/catch.hpp>

#include "derivation_world.h"

using namespace rinceau;

namespace {

/// A big shape in the middle, and rules that place one more there; B, D and E find room beside it.
const std::string collision_in_the_middle = R"(
shape big = box
shape b = box
shape d = box
shape e = box
axiom nearest 5 5 0 S(1,1,1) I("big") T(0.1,0,0) A
B ~ T(0,3,0) I("b")
D ~ T(3,0,0) I("d")
E ~ T(0,-3,0) I("e")
)";

std::string found(const std::string& rules) {
    const SurfacePattern pattern = grown(collision_in_the_middle + rules, plane_world());
    std::string names;
    for (const char* name : {"b", "d", "e"})
        if (count_of(pattern, name) == 1) names += name;
    CHECK(count_of(pattern, "big") == 1);
    return names;
}

}  // namespace

TEST_CASE("a collision culls what stands behind it and keeps what stands before it") {
    CHECK(found("A ~ B IC(\"big\") D E") == "b");
    CHECK(found("A ~ B I(\"big\") D E\noption collide = all") == "b");
}

TEST_CASE("a collision that is found rules later culls as well") {
    CHECK(found("A ~ B C D E\nC ~ F\nF ~ IC(\"big\")") == "b");
    CHECK(found("A ~ B C D E\nC ~ F\nF ~ K\nK ~ H\nH ~ [Rz(45) IC(\"big\")]") == "b");
}

TEST_CASE("a symbol that may place more than one thing, or waits, is derived later and culls nothing") {
    CHECK(found("A ~ B C D E\nC ~ IC(\"big\") B") == "bde");
    CHECK(found("A ~ B C D E\nC ~ IC(\"big\") @ -1") == "bde");
    CHECK(found("A ~ B C D E\nC ~ C IC(\"big\")\noption max_rules = 50") == "bde");
}

TEST_CASE("a collision in brackets culls the bracket, the production or nothing, as the option cull says") {
    const std::string rule = "A ~ B [IC(\"big\") D] E";
    CHECK(found(rule) == "be");
    CHECK(found(rule + "\noption cull = bracket") == "be");
    CHECK(found(rule + "\noption cull = rule") == "b");
    CHECK(found(rule + "\noption cull = none") == "bde");
    CHECK(found("A ~ B [[IC(\"big\")] D] E") == "bde");
    CHECK(found("A ~ B [[T(0.1,0,0) IC(\"big\") [D]] E]") == "be");
}

TEST_CASE("the end of the surface culls like a collision, whatever the option says") {
    for (const char* cull : {"bracket", "none"}) {
        const SurfacePattern pattern = grown(std::string("shape b = box\nshape d = box\naxiom nearest 5 5 0 A\n") +
                                                 "A ~ I(\"b\") [T(20,0,0) I(\"b\")] I(\"d\")\noption cull = " + cull,
                                             plane_world());
        CHECK(count_of(pattern, "b") == 1);
        CHECK(count_of(pattern, "d") == 1);
        CHECK(pattern.counts.borders_met == 1);
        CHECK(pattern.complete);
    }
}

TEST_CASE("a shape may touch the shapes that its own way has placed, and no others") {
    // pieces that overlap the one before, in a circle that comes back to the first
    const std::string ring = R"(
shape piece = box
axiom nearest 5 2 0 Piece(0)
Piece(n) : n < 40 ~ Seg T(0.7,0,0) Rz(15) Piece(n+1)
Seg ~ S(1,0.2,0.2) IC("piece")
)";
    const SurfacePattern pattern = grown(ring, plane_world());
    CHECK(pattern.placed.size() == 23);  // the 24th would lie on the first again
    CHECK(pattern.counts.collisions_avoided == 1);
    CHECK(grown(ring + "option kin = 0\n", plane_world()).placed.size() == 1);
}

TEST_CASE("a merged shape snaps to its twin and culls, as the twin has grown its successors") {
    const std::string text = R"(
shape dot = box
shape mark = box
axiom nearest 5 5 0 S(0.1,0.1,0.1) IM("dot",0.5,20) [T(0.3,0.1,0) Rz(15) IM("dot",0.5,20) T(2,0,0) I("mark")]
)";
    const SurfacePattern culled = grown(text, plane_world());
    CHECK(culled.placed.size() == 1);
    CHECK(culled.counts.merged_points == 1);
    const SurfacePattern goes_on = grown(text + "option cull = none\n", plane_world());
    REQUIRE(goes_on.placed.size() == 2);
    CHECK(abs(goes_on.placed[1].position - SpacePoint{7, 5, 0}) < 1e-12);
}

TEST_CASE("shapes farther apart or turned more than a merge allows are placed") {
    const std::string begin = "shape dot = box\nshape other = box\naxiom nearest 5 5 0 S(0.1,0.1,0.1) IM(\"dot\",0.5,20) ";
    CHECK(grown(begin + "[T(0.6,0,0) IM(\"dot\",0.5,20)]", plane_world()).placed.size() == 2);
    CHECK(grown(begin + "[T(0.4,0,0) Rz(30) IM(\"dot\",0.5,20)]", plane_world()).placed.size() == 2);
    CHECK(grown(begin + "[T(0.4,0,0) Rz(30) IM(\"dot\",0.5)]", plane_world()).placed.size() == 1);
    CHECK(grown(begin + "[T(0.4,0,0) IM(\"other\",0.5,20)]", plane_world()).placed.size() == 2);
}
