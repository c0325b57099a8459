#include "lsystem/interpret.h"

#include <catch2/catch.hpp>

#include "lsystem/grammar_text.h"

using namespace rinceau;

static std::vector<Placement> placed(const std::string& body, const InterpretOptions& options = {}) {
    return interpret(
        parse_grammar("lsystem 1\n" + body +
                      "\nstyle 1: fill none\nstyle 2: fill red\nterminal A: style 1; path \"M0 0L1 1\"\nterminal B:\n"),
        options);
}

static void check_pose(const Similarity& found, const Similarity& expected) {
    CHECK(abs(found.linear - expected.linear) < 1e-12);
    CHECK(abs(found.translation - expected.translation) < 1e-12);
    CHECK(found.mirrored == expected.mirrored);
}

TEST_CASE("every command is a product from the right") {
    check_pose(placed("axiom: A")[0].pose, {});
    check_pose(placed("axiom: +(30) A")[0].pose, rotate(radians(30)));
    check_pose(placed("axiom: -(30) A")[0].pose, rotate(radians(-30)));
    check_pose(placed("axiom: f(5) A")[0].pose, translate({0, 5}));
    check_pose(placed("axiom: +(90) f(5) A")[0].pose, translate({-5, 0}) * rotate(radians(90)));
    check_pose(placed("axiom: *(2) f(5) *(3) A")[0].pose, translate({0, 10}) * scale_by(6));
    check_pose(placed("axiom: | +(30) f(2) A")[0].pose, mirror_about_heading() * rotate(radians(30)) * translate({0, 2}));
    check_pose(placed("axiom: | f(2) A")[0].pose, translate({0, 2}) * mirror_about_heading());
    check_pose(placed("axiom: +(20) | -(50) *(0.5) f(3) | +(5) A")[0].pose,
               rotate(radians(20)) * mirror_about_heading() * rotate(radians(-50)) * scale_by(0.5) * translate({0, 3}) *
                   mirror_about_heading() * rotate(radians(5)));
}

TEST_CASE("an angle that is computed turns like one that is written") {
    const auto written = placed("axiom: +(37) f(1) -(11) A");
    const auto computed = placed("axiom: P(37, 11)\nP(a, b) -> +(a) f(1) -(b) A");
    CHECK(written[0].pose == computed[0].pose);
}

TEST_CASE("brackets keep pose, style and layer") {
    const auto placements = placed("axiom: [+(30) f(3) *(2) | ;(2) z(0) A] A");
    CHECK(placements[0].style == 2);
    CHECK(placements[1].style == 0);
    CHECK(placements[1].pose == Similarity{});
}

TEST_CASE("layers lift what follows, and order within a layer is that of derivation") {
    const auto placements = placed("axiom: A [z(1) A z(1) B] A [z(-1) B] A");
    std::vector<int> layers, orders;
    for (const Placement& placement : placements) {
        layers.push_back(placement.layer);
        orders.push_back(placement.order);
    }
    CHECK(layers == std::vector<int>{-1, 0, 0, 0, 1, 2});
    CHECK(orders == std::vector<int>{4, 0, 3, 5, 1, 2});
}

TEST_CASE("the trail leads from the axiom to the terminal and leaves recursion out") {
    const auto placements = placed("axiom: B [Q]\nQ -> f(1) P(3)\nP(m) : m > 0 -> [A] f(1) P(m-1)", {.trails = true});
    REQUIRE(placements.size() == 4);
    CHECK(placements[0].trail == std::vector<Occurrence>{{-1, 0}});
    CHECK(placements[0].production == -1);
    for (int i = 1; i <= 3; ++i) {
        CHECK(placements[static_cast<std::size_t>(i)].trail == std::vector<Occurrence>{{-1, 2}, {0, 1}, {1, 1}});
        CHECK(placements[static_cast<std::size_t>(i)].production == 1);
    }
}

TEST_CASE("an exception adds its own occurrence to the trail") {
    const auto placements =
        placed("axiom: P(2)\nP(m) : m > 0 -> [A] f(1) P(m-1)\nexcept 1.2 -> f(1) B", {.addresses = true, .trails = true});
    CHECK(placements[1].trail == std::vector<Occurrence>{{-1, 0}, {0, 1}, {-2, 1}});
    CHECK(placements[1].address == std::vector<int>{1, 2});
    CHECK(placements[1].production == 0);
}

TEST_CASE("poses do not depend on whether addresses and trails are kept") {
    const std::string body = "axiom: P(5)\nP(m) : m > 0 -> [+(m) A] f(m) | P(m-1)";
    const auto plain = placed(body);
    const auto tracked = placed(body, {.addresses = true, .trails = true});
    REQUIRE(plain.size() == tracked.size());
    for (std::size_t i = 0; i < plain.size(); ++i) CHECK(plain[i].pose == tracked[i].pose);
}

TEST_CASE("commands that cannot be obeyed are reported") {
    for (const char* body :
         {"axiom: A ] A", "axiom: *(0) A", "axiom: *(-1) A", "axiom: ;(3) A", "axiom: ;(0.5) A", "axiom: z(0.5) A",
          "axiom: f(1e308) f(1e308) A", "axiom: P(40)\nP(m) : m > 0 -> *(1e-9) P(m-1)\nP(m) -> A"}) {
        INFO(body);
        CHECK_THROWS_AS(placed(body), InputError);
    }
    CHECK_THROWS_AS(interpret(parse_grammar("lsystem 1\naxiom: A\nterminal A: style 3")), InputError);
}

TEST_CASE("placements one by one are those of the list, in order of derivation") {
    const Grammar grammar = parse_grammar(
        "lsystem 1\naxiom: P(9) z(-1) A\nP(m) : m > 0 -> [z(m % 3) A] f(2) P(m-1)\nterminal A: path \"M0 0L1 1\"\n");
    const InterpretOptions options{.addresses = true, .trails = true};
    std::vector<Placement> visited;
    visit_placements(grammar, options, [&](const Placement& placement) { visited.push_back(placement); });
    const std::vector<Placement> listed = interpret(grammar, options);
    REQUIRE(visited.size() == listed.size());
    for (const Placement& placement : listed) {
        const Placement& same = visited.at(static_cast<std::size_t>(placement.order));
        CHECK(same.order == placement.order);
        CHECK(same.layer == placement.layer);
        CHECK(same.pose == placement.pose);
        CHECK(same.address == placement.address);
        CHECK(same.trail == placement.trail);
    }
}
