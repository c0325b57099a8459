#include <catch2/catch.hpp>

#include "derivation_world.h"
#include "growth/surface/surface_world.h"

using namespace rinceau;

namespace {

std::string message_of(const std::string& text, SurfaceWorld world = plane_world()) {
    try {
        grown(text, std::move(world));
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

const std::string begin = "shape a = box\naxiom nearest 5 5 0 Grow(3)\n";

}  // namespace

TEST_CASE("sizes that are not positive are refused with rule and line") {
    const std::string message =
        message_of(begin + "Grow(n) ~ S(1,1,1) I(\"a\") Grow2(n-1)\nGrow2(n) ~ S(n-2,1,1) I(\"a\")\n");
    CHECK(holds(message, "test.fgsg:4"));
    CHECK(holds(message, "Grow2"));
    CHECK(holds(message, "above 0"));
}

TEST_CASE("numbers that are not finite are refused with the line") {
    CHECK(holds(message_of(begin + "Grow(n) ~ T(1/(n-3),0,0) I(\"a\")\n"), "test.fgsg:3"));
    CHECK(holds(message_of(begin + "Grow(n) ~ S(sqrt(-n),1,1) I(\"a\")\n"), "test.fgsg:3"));
    CHECK(holds(message_of(begin + "Grow(n) ~ LineSeg(-1,1)\n"), "test.fgsg:3"));
    CHECK(holds(message_of(begin + "Grow(n) ~ I(\"a\") : n-4\n"), "test.fgsg:3"));
}

TEST_CASE("unknown symbols, shapes and fields are refused before anything grows") {
    CHECK(holds(message_of(begin + "Grow(n) ~ Other\n"), "Other"));
    CHECK(holds(message_of(begin + "Grow(n) ~ I(\"b\")\n"), "b"));
    CHECK(holds(message_of(begin + "Grow(n) ~ Rz(F2.Xangle1) I(\"a\")\n"), "F2"));
    CHECK(holds(message_of(begin + "Grow(n) ~ I(\"a\")\noption follow = F7\n"), "F7"));
}

TEST_CASE("axioms that name no place, and options that cannot be, are refused") {
    CHECK(holds(message_of("shape a = box\naxiom vertex 100000 I(\"a\")\n"), "vertex"));
    CHECK(holds(message_of("shape a = box\naxiom scatter -1 I(\"a\")\n"), "places"));
    CHECK(holds(message_of(begin + "Grow(n) ~ I(\"a\")\noption cull = all\n"), "bracket, rule or none"));
    CHECK(holds(message_of(begin + "Grow(n) ~ I(\"a\")\noption touch = 2\n"), "touch"));
}

TEST_CASE("a condition that never holds ends a branch without a word") {
    const SurfacePattern pattern = grown(begin + "Grow(n) : n < 0 ~ I(\"a\")\n", plane_world());
    CHECK(pattern.complete);
    CHECK(pattern.placed.empty());
}

TEST_CASE("the limit of seconds holds while axioms are placed, too") {
    ShapeDerivationOptions options;
    options.max_seconds = 0.01;  // one walk as long as this takes more
    const SurfacePattern pattern =
        grown("shape a = box\naxiom scatter 400 T(1e12) I(\"a\")\n", bare_world(torus_triangles(24, 12, 2, 0.7)), options);
    CHECK_FALSE(pattern.complete);
    CHECK(holds(pattern.limit, "seconds"));
    CHECK(count_of(pattern, "a") < 400);
}

TEST_CASE("a line that is caught in a singular point does not come back to its start, and is not waited for") {
    const ShapeGrammar grammar = parse_shape_grammar(
        "param s = 0.035 * diagonal\n"
        "param middle = (left + right) / 2\n"
        "param high = (bottom + top) / 2\n"
        "field F1 = direction y = 1\n"
        "shape pearl = sphere\n"
        "axiom nearest middle high front [Row(1)] T(-1.05*s,0,0) Row(-1)\n"
        "axiom scatter 60 [Row(1)] T(-1.05*s,0,0) Row(-1)\n"
        "Row(way) : near(\"pearl\") > 0.8*s ~ [Rz(90) String] T(1>05*way*s,0,0) Row(way) @ -1\n"
        "String : F1.loop > 2*s ~ Pearl(3*round(F1.loop/(3*s)), F1.loop/(3*round(F1.loop/(3+s))), 0)\n"
        "Pearl(n,w,i) : i < n ~ S(0.92*w,0.92*w,0.8*s) IC(\"pearl\") T(w,0,0) Pearl(n,w,i+1)\n");
    const auto torus = std::make_shared<const SurfaceMesh>(surface_mesh(torus_triangles(12, 8, 2, 0.7)));
    ShapeDerivationOptions options = options_of(grammar);
    options.max_seconds = 1;
    CHECK(derive_shapes(grammar, make_world(grammar, torus, {}), options).counts.rules_applied > 0);
}
