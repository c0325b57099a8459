#include "lsystem/derivation_graph.h"

#include <algorithm>

#include <catch2/catch.hpp>

#include "lsystem/grammar_text.h"
#include "lsystem/interpret.h"

using namespace rinceau;

static Grammar grammar_of(const std::string& body) { return parse_grammar("lsystem 1\n" + body); }

struct Placed {
    GraphLook look;
    Similarity pose;
    int layer = 0;
};

static void unfold(const DerivationGraph& graph, int part, const Similarity& pose, int layer, std::vector<Placed>& placed) {
    for (const PartItem& item : graph.parts[static_cast<std::size_t>(part)].items) {
        if (item.is_look) {
            placed.push_back({graph.looks[static_cast<std::size_t>(item.index)], pose * item.pose, layer + item.layer});
        } else {
            unfold(graph, item.index, pose * item.pose, layer + item.layer, placed);
        }
    }
}

static void check_same_picture(const Grammar& grammar) {
    const auto graph = derivation_graph(grammar);
    REQUIRE(graph);
    std::vector<Placed> placed;
    unfold(*graph, static_cast<int>(graph->parts.size()) - 1, {}, 0, placed);
    std::ranges::stable_sort(placed, {}, &Placed::layer);
    const auto wanted = interpret(grammar);
    REQUIRE(placed.size() == wanted.size());
    CHECK(graph->parts.back().placements == wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        CHECK(placed[i].look.terminal == wanted[i].terminal);
        CHECK(placed[i].look.style == wanted[i].style);
        CHECK(placed[i].layer == wanted[i].layer);
        CHECK(placed[i].pose.mirrored == wanted[i].pose.mirrored);
        CHECK(abs(placed[i].pose.linear - wanted[i].pose.linear) < 1e-12);
        CHECK(abs(placed[i].pose.translation - wanted[i].pose.translation) < 1e-10);
    }
}

static const std::string facade =
    "axiom: Right(3) Storeys(3) ;(2) Sky Storeys(1)\nRight(d) -> -(90) f(d) +(90)\n"
    "Storeys(m) : m > 0 -> [Windows(5)] f(9) Storeys(m-1)\nWindows(m) : m > 0 -> [Window] Right(8) Windows(m-1)\n"
    "Window -> Frame [| z(1) Pane]\nstyle 2: fill red\nterminal Frame: path \"M0 0H1\"\nterminal Pane: path \"M0 0H2\"\n"
    "terminal Sky: path \"M0 0H3\"\n";

TEST_CASE("the parts of a picture are what its rules say, once each") {
    const auto graph = derivation_graph(grammar_of(facade));
    REQUIRE(graph);
    std::vector<std::string> symbols;
    for (const GraphPart& part : graph->parts) symbols.push_back(part.symbol);
    // under style 2 the same rules make other parts
    CHECK(symbols == std::vector<std::string>{"Window", "Windows", "Storeys", "Window", "Windows", "Storeys", ""});
    CHECK(graph->parts[1].items.size() == 5);
    CHECK(graph->parts[2].items.size() == 3);
    check_same_picture(grammar_of(facade));
}

TEST_CASE("a tree has a part for each depth") {
    const std::string koch =
        "axiom: F(6)\nF(n) : n > 0 -> F(n-1) +(60) F(n-1) -(120) F(n-1) +(60) F(n-1)\nF(n) : n == 0 -> Line f(1)\n"
        "terminal Line: path \"M0 0V-1\"\n";
    const auto graph = derivation_graph(grammar_of(koch));
    REQUIRE(graph);
    CHECK(graph->parts.size() == 8);
    CHECK(graph->parts.back().placements == 4096);
    check_same_picture(grammar_of(koch));
}

TEST_CASE("exceptions and mirrored, scaled parts keep the picture") {
    check_same_picture(grammar_of(facade + "except 2.2.3 -> Frame +(3) Window\nexcept 2.3 ->\n"));
    check_same_picture(
        grammar_of("axiom: T(5)\nT(m) : m > 0 -> A f(2) [+(20) *(0.7) | T(m-1)] z(-1) -(33) *(0.8) T(m-1) A\n"
                   "terminal A: path \"M0 0V-1\"\n"));
}

TEST_CASE("a bracket that another rule closes makes no parts") {
    CHECK_FALSE(derivation_graph(grammar_of("axiom: P A Q\nP -> [ f(1)\nQ -> ]\nterminal A:\n")));
    CHECK_FALSE(derivation_graph(grammar_of("axiom: [ f(1) Q A\nQ -> ]\nterminal A:\n")));
}

TEST_CASE("a picture of nothing has its axiom") {
    const auto graph = derivation_graph(grammar_of("axiom: f(1)"));
    REQUIRE(graph);
    CHECK(graph->parts.size() == 1);
    CHECK(graph->parts.back().placements == 0);
}
