// Members on a circle that all face one way, and what they and other groups are made of: halves in one place, discs with
// rings.

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>

#include "closed_loop/findings.h"
#include "closed_loop/known_grammar.h"
#include "closed_loop/shapes.h"
#include "lsystem/grammar_text.h"
#include "lsystem/interpret.h"
#include "lsystem/to_scene.h"

using namespace rinceau;
using namespace rinceau::test;

namespace {

const Color yellow{255, 200, 0}, dark{0, 60, 150}, bright{200, 20, 40};

std::vector<std::pair<std::string, Element>> upright_shapes() {
    return {{"hook", element(transformed(hook(), scale_by(8)), filled(yellow))},
            {"star", element(transformed(star(5, 0.382), scale_by(9)), filled(yellow))},
            {"leaf", element(transformed(leaf(), scale_by(9)), filled(yellow))},
            {"square", element(rectangle(12, 12), filled(yellow))}};
}

Analysis analysed(const std::string& rules, const std::vector<std::pair<std::string, Element>>& terminals,
                  double rounding = 1e-3) {
    Random random(5);
    return analyze(shuffled(rounded(drawn_scene(known_grammar(rules, terminals)), rounding), random));
}

const Production* production(const Grammar& grammar, const std::string& symbol) {
    const auto found = std::ranges::find(grammar.productions, symbol, &Production::symbol);
    return found == grammar.productions.end() ? nullptr : &*found;
}

/// Each element moved by up to `share` in x and in y; those of one group of `together` alike.
Scene moved_by_hand(Scene scene, double share, std::size_t together) {
    Random random(11);
    Point shift;
    for (std::size_t e = 0; e < scene.elements.size(); ++e) {
        if (e % together == 0) shift = {random.uniform(-share, share), random.uniform(-share, share)};
        scene.elements[e] = placed(scene.elements[e], translate(shift));
        scene.viewport = including(scene.viewport, painted_box(scene.elements[e]));
    }
    return scene;
}

}  // namespace

TEST_CASE("members of a circle that face one way are a ring, whose count can be changed") {
    for (const auto& [name, shape] : upright_shapes()) {
        for (const int count : {5, 7, 12, 16}) {
            if (name == "star" && count == 5) continue;  // they turn with the ring as well
            const std::string turn = std::to_string(360.0 / static_cast<double>(count));
            const Analysis found = analysed("axiom: P(" + std::to_string(count) + ")\nP(m) : m > 0 -> [f(100) -(" + turn +
                                                "*(" + std::to_string(count) + "-m)) A] +(" + turn + ") P(m-1)",
                                            {{"A", shape}});
            INFO(name << " " << count << "\n" << to_text(found.grammar));
            CHECK(found.report.check.passed);
            REQUIRE(found.grammar.productions.size() == 1);
            CHECK(found.grammar.productions.front().symbol == "Ring");
            CHECK(found.grammar.productions.front().comment.starts_with("a ring of " + std::to_string(count) +
                                                                        " A, all facing one way"));
            CHECK(found.grammar.exceptions.empty());
            CHECK(axiom_symbols(found.grammar) == 1);
            // Two more: still a circle, all facing the same way.
            Grammar other = found.grammar;
            REQUIRE(other.constants.size() == 1);
            other.constants.front().value = number_expression(count + 2);
            const std::vector<Placement> more = interpret(other);
            REQUIRE(more.size() == static_cast<std::size_t>(count) + 2);
            Point middle{};
            for (const Placement& each : more) middle += each.pose.translation / static_cast<double>(more.size());
            for (const Placement& each : more) {
                CHECK(abs(each.pose.linear - more.front().pose.linear) < 1e-3);
                CHECK(abs(each.pose.translation - middle) ==
                      Approx(abs(more.front().pose.translation - middle)).epsilon(1e-3));
            }
        }
    }
}

TEST_CASE("part of a circle whose members face one way is an arc about its centre") {
    for (const auto& [name, shape] : upright_shapes()) {
        const Analysis found = analysed("axiom: P(8)\nP(m) : m > 0 -> [f(100) -(18*(8-m)) A] +(18) P(m-1)", {{"A", shape}});
        INFO(name << "\n" << to_text(found.grammar));
        CHECK(found.report.check.passed);
        REQUIRE(found.grammar.productions.size() == 1);
        CHECK(found.grammar.productions.front().symbol == "Arc");
        CHECK(found.grammar.productions.front().comment == "an arc of 8 A, all facing one way, 18 degrees apart");
        CHECK(axiom_symbols(found.grammar) == 1);
    }
}

TEST_CASE("two equal circles of members that face one way share their rule, also if one is turned with all its members") {
    const std::string ring = "P(m) : m > 0 -> [f(60) -(40*(9-m)) A] +(40) P(m-1)";
    for (const auto& [name, shape] : upright_shapes()) {
        const Analysis found =
            analysed("axiom: [P(9)] [f(230) +(25) P(9)] [f(90) -(90) f(400) P(9)]\n" + ring, {{"A", shape}});
        INFO(name << "\n" << to_text(found.grammar));
        CHECK(found.report.check.passed);
        CHECK(found.grammar.productions.size() <= 2);
        REQUIRE(production(found.grammar, "Ring") != nullptr);
        CHECK(production(found.grammar, "Ring")->comment.starts_with("a ring of 9 A, all facing one way"));
    }
}

TEST_CASE("a flag's stars are whole stars in a circle, though each is made of ten triangles and placed by hand") {
    // Two mirror halves of a ray, five rays, twelve stars.
    const Element half = element({polygon({{0, 20}, {0, 0}, {4.49, 6.18}})}, filled(yellow));
    const std::string stars =
        "axiom: P(12)\nP(m) : m > 0 -> [f(140) -(30*(12-m)) S] +(30) P(m-1)\nS -> [H(5)] [| H(5)]\nH(m) : m > 0 -> [A] "
        "+(72) H(m-1)";
    const Scene exact = drawn_scene(known_grammar(stars, {{"A", half}}));
    REQUIRE(exact.elements.size() == 120);
    for (const bool by_hand : {false, true}) {
        const Analysis found = analyze(by_hand ? moved_by_hand(exact, 1.5, 10) : exact);
        INFO(to_text(found.grammar));
        CHECK(found.report.check.passed);
        CHECK(axiom_symbols(found.grammar) == 1);
        REQUIRE(production(found.grammar, "Ring") != nullptr);
        CHECK(production(found.grammar, "Ring")->comment.starts_with("a ring of 12 Pair, all facing one way"));
        // A star is moved as a whole.
        CHECK(found.grammar.exceptions.size() == (by_hand ? 12 : 0));
        CHECK(found.report.grammar_bits < 0.2 * found.report.drawing_bits);
    }
}

TEST_CASE("stars set round a circle by hand are a ring") {
    for (const auto& [name, shape] : upright_shapes()) {
        const Scene exact =
            drawn_scene(known_grammar("axiom: P(12)\nP(m) : m > 0 -> [f(100) -(30*(12-m)) A] +(30) P(m-1)", {{"A", shape}}));
        const Analysis found = analyze(moved_by_hand(exact, 2, 1));
        INFO(name << "\n" << to_text(found.grammar));
        CHECK(found.report.check.passed);
        REQUIRE(found.grammar.productions.size() == 1);
        CHECK(found.grammar.productions.front().comment.starts_with("a ring of 12 A, all facing one way"));
        CHECK(found.grammar.exceptions.size() <= 12);
        const Analysis layout = analyze(moved_by_hand(exact, 2, 1), {.symmetrize = true});
        CHECK(layout.report.check.passed);
        CHECK(layout.grammar.exceptions.empty());
    }
}

TEST_CASE("groups that are placed by hand are moved as groups") {
    const std::string rows =
        "axiom: Q(6)\nQ(n) : n > 0 -> [P(7)] f(60) Q(n-1)\nP(m) : m > 0 -> [F] -(90) f(60) +(90) P(m-1)\n"
        "F -> [A] [f(12) B] [-(120) f(15) C]";
    const Scene exact = drawn_scene(known_grammar(rows, {{"A", element(transformed(hook(), scale_by(8)), filled(dark))},
                                                         {"B", element(rectangle(5, 9), filled(bright))},
                                                         {"C", element(transformed(leaf(), scale_by(6)), filled(yellow))}}));
    REQUIRE(exact.elements.size() == 126);
    const Analysis found = analyze(moved_by_hand(exact, 2, 3));
    INFO(to_text(found.grammar));
    CHECK(found.report.check.passed);
    CHECK(axiom_symbols(found.grammar) == 1);
    CHECK(found.grammar.productions.size() == 3);
    CHECK(found.grammar.exceptions.size() <= 42);
    for (const Exception& exception : found.grammar.exceptions)
        CHECK(exception.successor.back().symbol.starts_with("Motif"));
}

TEST_CASE("what is exact in itself keeps its rules where its copies are placed by hand") {
    // Keys of a calculator: columns of three and one farther off, drawn once, copied and laid side by side.
    const Scene exact =
        drawn_scene(known_grammar("axiom: Q(9)\nQ(n) : n > 0 -> [C] -(90) f(50) +(90) Q(n-1)\nC -> [P(3)] [f(180) A]\nP(m) "
                                  ": m > 0 -> [A] f(52) P(m-1)",
                                  {{"A", element(rectangle(30, 24), filled(dark))}}));
    REQUIRE(exact.elements.size() == 36);
    const Analysis found = analyze(moved_by_hand(exact, 3, 4));
    INFO(to_text(found.grammar));
    CHECK(found.report.check.passed);
    CHECK(axiom_symbols(found.grammar) == 1);
    CHECK(found.grammar.productions.size() == 3);
    CHECK(found.grammar.exceptions.size() <= 9);
    const Analysis layout = analyze(moved_by_hand(exact, 3, 4), {.symmetrize = true});
    CHECK(layout.grammar.exceptions.empty());
    CHECK(axiom_symbols(layout.grammar) == 1);
}

TEST_CASE("a disc and the ring about it are one thing before they stand in rows, whatever their outlines begin with") {
    Scene scene;
    Random random(3);
    const std::vector<Color> colours{{200, 30, 30},  {30, 160, 60},  {30, 60, 200},
                                     {200, 180, 30}, {150, 60, 160}, {60, 160, 170}};
    for (int column = 0; column < 6; ++column) {
        for (int row = 0; row < 8; ++row) {
            const Similarity place = translate({40.0 * column, 30.0 * row}) * rotate(random.uniform(0, 1));
            scene.elements.push_back(placed(element(circle(10), filled(colours[static_cast<std::size_t>(column)])), place));
            scene.elements.push_back(placed(element(circle(5), filled(dark)), place));
        }
    }
    scene.viewport = {{-20, -20}, {230, 240}};
    const Analysis found = analyze(scene);
    INFO(to_text(found.grammar));
    CHECK(found.report.check.passed);
    CHECK(axiom_symbols(found.grammar) == 1);
    CHECK(found.grammar.exceptions.empty());
    const Production* nest = production(found.grammar, "Nest");
    REQUIRE(nest != nullptr);
    CHECK(nest->comment.starts_with("a nest of 2"));
}

TEST_CASE("discs on a circle have no angle, however large a circle of the drawing is") {
    for (const double large : {20, 70, 100}) {
        const std::string rules = "axiom: [*(" + std::to_string(large / 10) +
                                  ") disc] Ring(7)\nRing(m) : m > 0 -> [f(80) disc] +(360/7) Ring(m-1)";
        const auto discs = element(transformed(circle(), scale_by(10)), stroked(dark, 1));
        const Analysis analysis = analysed(rules, {{"disc", discs}}, 1e-4);
        const std::string text = to_text(analysis.grammar);
        CAPTURE(large, text);
        CHECK(text.find("Ring(m) : m > 0 -> [f(8") != std::string::npos);
        CHECK(text.find("Ring_count*m") == std::string::npos);  // they do not "face one way"
    }
}
