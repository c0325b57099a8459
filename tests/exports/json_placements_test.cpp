#include "exports/json_placements.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "lsystem/grammar_text.h"

using namespace rinceau;

static nlohmann::json placements_of(const std::string& body) {
    return nlohmann::json::parse(to_placements(parse_grammar("lsystem 1\n" + body)).bytes);
}

TEST_CASE("placements are listed in paint order with SVG's matrices") {
    const auto list = placements_of(
        "canvas 1 2 30 40\naxiom: [z(1) f(5) A] -(90) f(7) *(2) ;(2) A\nstyle 1: fill none; stroke #123456\nstyle 2: fill "
        "red\n"
        "terminal A: style 1; path \"M0 0L1 2\"");
    CHECK(list["format"] == "rinceau-placements");
    CHECK(list["canvas"] == std::vector<double>{1, 2, 30, 40});
    CHECK(list["styles"][0]["stroke"] == "#123456");
    CHECK(list["terminals"][0]["path"] == "M0 0L1 2");
    REQUIRE(list["placements"].size() == 2);
    // up is -y, a turn to the right is positive
    CHECK(list["placements"][0]["matrix"] == std::vector<double>{0, 2, -2, 0, 7, 0});
    CHECK(list["placements"][0]["style"] == 2);
    CHECK(list["placements"][1]["matrix"] == std::vector<double>{1, 0, 0, 1, 0, -5});
    CHECK(list["placements"][1]["style"] == 1);
    CHECK(list["placements"][1]["layer"] == 1);
}

TEST_CASE("a picture without canvas and a mirrored placement are said as they are") {
    const auto list = placements_of("axiom: | A\nterminal A: path \"M0 0L1 2\"");
    CHECK(list["canvas"].is_null());
    CHECK(list["placements"][0]["matrix"] == std::vector<double>{-1, 0, 0, 1, 0, 0});
}
