#include <catch2/catch.hpp>

#include "derivation_world.h"
#include "geometry/angle.h"
#include "growth/surface/curvature_field.h"

using namespace rinceau;

namespace {

/// A field of the plane in closed form on [0, 10]^2.
SurfaceWorld plane_with(PlaneForm form, int n) {
    SurfaceWorld world = plane_world();
    SurfaceField field;
    field.n = n;
    field.exact = form;
    world.fields.push_back({"F1", std::make_shared<FieldOnSurface>(*world.surface, std::move(field))});
    return world;
}

/// The numbers that a rule's queries give at a place, as attributes of what it places there.
std::map<std::string, double> asked(const SurfaceWorld& world, const std::string& before,
                                    const std::vector<std::string>& queries) {
    std::string text = "shape dot = box\nfield F1 = curvature\n" + before;
    for (std::size_t i = 0; i < queries.size(); ++i) text += " Set(\"" + std::to_string(i) + "\", " + queries[i] + ")";
    SurfaceWorld with_field = world;
    if (with_field.fields.empty()) {
        SurfaceField field = curvature_field(*world.surface);
        with_field.fields.push_back({"F1", std::make_shared<FieldOnSurface>(*world.surface, std::move(field))});
    }
    const SurfacePattern pattern = grown(text + " S(0.1) I(\"dot\")\n", with_field);
    REQUIRE_FALSE(pattern.placed.empty());
    std::map<std::string, double> answers;
    for (std::size_t i = 0; i < queries.size(); ++i)
        answers[queries[i]] = pattern.placed.back().attributes.at(std::to_string(i));
    return answers;
}

}  // namespace

TEST_CASE("angles to a field are signed, and turning by them aligns the scope") {
    const SurfaceWorld lines = plane_with({false, {}, radians(30)}, 2);
    // an axiom's X is along the field: turn it away first
    auto found = asked(lines, "axiom nearest 5 5 0 Rz(20)", {"F1.Xangle1", "F1.Xangle2"});
    CHECK(found["F1.Xangle1"] == Approx(-20));
    CHECK(found["F1.Xangle2"] == Approx(70));
    found = asked(lines, "axiom nearest 5 5 0 Rz(120)", {"F1.Xangle1", "F1.Xangle2"});
    CHECK(found["F1.Xangle1"] == Approx(60));
    CHECK(found["F1.Xangle2"] == Approx(-30));
    found = asked(plane_with({false, {}, radians(30)}, 1), "axiom nearest 5 5 0 Rz(120)", {"F1.Xangle1", "F1.Xangle2"});
    CHECK(found["F1.Xangle1"] == Approx(-120));
    CHECK(found["F1.Xangle2"] == Approx(-30));
    found = asked(plane_with({false, {}, radians(30)}, 4), "axiom nearest 5 5 0 Rz(70)", {"F1.Xangle1"});
    CHECK(found["F1.Xangle1"] == Approx(20));
    found = asked(lines, "axiom nearest 5 5 0 Rz(20) Rz(F1.Xangle1)", {"F1.Xangle1"});
    CHECK(std::abs(found["F1.Xangle1"]) < 1e-9);
}

TEST_CASE("vectors, place, size and normal are those of the scope") {
    const auto found =
        asked(plane_with({false, {}, radians(30)}, 1), "axiom nearest 5 4 0 S(1,2,3) T(0,0,0.5)",
              {"F1.vector1.x", "F1.vector1.y", "F1.vector2.x", "F1.length1", "P.x", "P.y", "P.z", "S.y", "N.z", "depth"});
    CHECK(found.at("F1.vector1.x") == Approx(std::cos(radians(30))));
    CHECK(found.at("F1.vector1.y") == Approx(0.5));
    CHECK(found.at("F1.vector2.x") == Approx(-0.5));
    CHECK(found.at("F1.length1") == Approx(1));
    CHECK(found.at("P.x") == Approx(5));
    CHECK(found.at("P.y") == Approx(4));
    CHECK(found.at("P.z") == Approx(0.5));
    CHECK(found.at("S.y") == 2);
    CHECK(found.at("N.z") == Approx(1));
    CHECK(found.at("depth") == 0);
}

TEST_CASE("a radial field diverges and does not turn, a vortex turns and does not diverge") {
    const PlaneForm radial{true, {5, 5}, 0}, vortex{true, {5, 5}, pi / 2};
    auto found = asked(plane_with(radial, 1), "axiom nearest 7 5 0", {"F1.div", "F1.curl", "F1.curvature", "F1.dist"});
    CHECK(found["F1.div"] == Approx(0.5).epsilon(0.01));  // 1 / r
    CHECK(std::abs(found["F1.curl"]) < 0.01);
    CHECK(std::abs(found["F1.curvature"]) < 0.01);
    CHECK(found["F1.dist"] == Approx(2).epsilon(0.05));
    found = asked(plane_with(vortex, 1), "axiom nearest 7 5 0", {"F1.div", "F1.curl", "F1.curvature"});
    CHECK(std::abs(found["F1.div"]) < 0.01);
    CHECK(found["F1.curl"] == Approx(0.5).epsilon(0.01));
    CHECK(found["F1.curvature"] == Approx(0.5).epsilon(0.01));
}

TEST_CASE("curvatures of a torus are those of its outer circle") {
    const SurfaceWorld world = bare_world(torus_triangles(120, 60, 2, 0.5));
    const auto found =
        asked(world, "axiom nearest 2.5 0 0", {"F1.maxcurv", "F1.mincurv", "F1.mean", "F1.gauss", "F1.gradient.x"});
    CHECK(found.at("F1.maxcurv") == Approx(2).epsilon(0.02));
    CHECK(found.at("F1.mincurv") == Approx(0.4).epsilon(0.02));
    CHECK(found.at("F1.mean") == Approx(1.2).epsilon(0.02));
    CHECK(found.at("F1.gauss") == Approx(0.8).epsilon(0.04));
}

TEST_CASE("shapes can be counted, and the nearest other one is found") {
    const std::string text = R"(
shape a = box
shape b = box
axiom nearest 2 5 0 Lay(0)
axiom nearest 5 5 0 S(0.1) [T(0,1,0) I("b")] Set("near", near("b")) Set("count", count("a")) Set("none", near("a")) I("b")
axiom nearest 5 5 0 S(0.1) I("b") Set("near", near("b")) Set("far", near("a")) I("b")
Lay(n) : n < 0 ~ I("a")
)";
    const SurfaceWorld world = plane_world();
    const SurfacePattern pattern = grown(text, world);
    REQUIRE(pattern.placed.size() == 4);
    CHECK(pattern.placed[1].attributes.at("near") == Approx(1));
    CHECK(pattern.placed[1].attributes.at("count") == 0);
    CHECK(pattern.placed[1].attributes.at("none") == Approx(world.surface->diagonal));
    CHECK(pattern.placed[3].attributes.at("near") == Approx(0).margin(1e-12));  // not its own, but that of the axiom before
    const SurfacePattern counted =
        grown("shape a = box\naxiom nearest 5 5 0 More\nMore : count(\"a\") < 7 ~ S(0.1) I(\"a\") T(0.2,0,0) More\n", world);
    CHECK(counted.placed.size() == 7);
}

TEST_CASE("a line that comes back to its start has a length, one that does not has none") {
    SurfaceWorld world = plane_with({true, {5, 5}, 0}, 1);
    auto found = asked(world, "axiom nearest 7 5 0 Rz(90)", {"F1.loop"});
    CHECK(found["F1.loop"] == Approx(2 * pi * 2).epsilon(2e-3));  // a circle about the centre
    found = asked(world, "axiom nearest 7 5 0 Rz(80)", {"F1.loop"});
    CHECK(found["F1.loop"] == 0);  // a spiral
    found = asked(world, "axiom nearest 7 5 0", {"F1.loop"});
    CHECK(found["F1.loop"] == 0);  // out to the border
}
