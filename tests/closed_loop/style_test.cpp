// Colours by rule -> drawing -> analysis -> the same rule: one shape in several styles is one terminal.

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>
#include <vector>

#include "closed_loop/findings.h"
#include "closed_loop/known_grammar.h"
#include "closed_loop/shapes.h"
#include "lsystem/grammar_text.h"

using namespace rinceau;
using namespace rinceau::test;

namespace {

Color shade(int k) {
    const auto channel = [&](int factor) { return static_cast<std::uint8_t>(20 + factor * k % 230); };
    return {channel(37), channel(91), channel(17)};
}

using Shapes = std::vector<std::pair<std::string, std::vector<Path>>>;

/// What the rules draw with these shapes and `colours` styles, numbered from 1.
Scene tinted_scene(const std::string& rules, const Shapes& shapes, int colours) {
    std::vector<std::pair<std::string, Element>> terminals;
    for (const auto& [symbol, paths] : shapes) terminals.emplace_back(symbol, element(paths, filled({0, 0, 0})));
    Grammar grammar = known_grammar(rules, terminals);
    grammar.styles.clear();
    for (int k = 1; k <= colours; ++k) grammar.styles.push_back({k, filled(shade(k)), ""});
    for (Terminal& terminal : grammar.terminals) terminal.style = 1;
    return drawn_scene(grammar);
}

Analysis analysed(const Scene& scene) {
    Analysis found = analyze(scene);
    CHECK(found.report.check.passed);
    return found;
}

std::string text_of(const Analysis& found) { return to_text(found.grammar); }

}  // namespace

TEST_CASE("colours that alternate along a row are one rule of one shape") {
    const Scene scene = tinted_scene("axiom: R(12)\nR(m) : m > 0 -> [;(1 + m % 2) A] f(3) R(m-1)", {{"A", hook()}}, 2);
    const Analysis found = analysed(scene);
    INFO(text_of(found));
    CHECK(rules_in_words(found.report) == "sequence of 12");
    CHECK(found.report.terminals.size() == 1);
    CHECK(found.grammar.exceptions.empty());
}

TEST_CASE("three colours in turn around a ring are one rule of one shape") {
    const Scene scene =
        tinted_scene("axiom: R(12)\nR(m) : m > 0 -> [f(10) ;(1 + m % 3) A] +(30) R(m-1)", {{"A", leaf()}}, 3);
    const Analysis found = analysed(scene);
    INFO(text_of(found));
    CHECK(rules_in_words(found.report) == "ring of 12");
    CHECK(found.report.terminals.size() == 1);
    CHECK(found.grammar.exceptions.empty());
}

TEST_CASE("a checkerboard is a row of rows of one shape") {
    const Scene scene = tinted_scene(
        "axiom: G(8)\nG(m) : m > 0 -> [R(6, m)] f(3) G(m-1)\nR(m, c) : m > 0 -> [;(1 + (m + c) % 2) A] +(90) f(3) -(90) R(m-1, c)",
        {{"A", rectangle(2.8, 2.8)}}, 2);
    const Analysis found = analysed(scene);
    INFO(text_of(found));
    CHECK(found.report.productions.size() == 2);
    CHECK(found.report.terminals.size() == 1);
    CHECK(found.grammar.exceptions.empty());
    CHECK(axiom_symbols(found.grammar) == 1);
}

TEST_CASE("a gradient along a row counts through its styles") {
    const Scene scene = tinted_scene("axiom: R(12)\nR(m) : m > 0 -> [;(m) A] f(3) R(m-1)", {{"A", hook()}}, 12);
    const Analysis found = analysed(scene);
    INFO(text_of(found));
    CHECK(rules_in_words(found.report) == "sequence of 12");
    CHECK(found.report.terminals.size() == 1);
    CHECK(found.grammar.exceptions.empty());
}

TEST_CASE("three copies of a group in three colours are one rule with its colour as parameter") {
    const Shapes shapes{{"A", hook()}, {"B", star(5)}, {"C", leaf()}, {"D", rectangle(2, 1)}};
    const Scene scene = tinted_scene(
        "axiom: [C1(2)] [f(40) +(50) C1(3)] [f(70) -(70) f(20) C1(4)]\n"
        "C1(c) -> [;(c) A] [f(3) ;(c + 3) B] [+(70) f(4) ;(1) C] [-(120) f(2) ;(c) D] [-(50) f(5) ;(1) D]",
        shapes, 7);
    const Analysis found = analysed(scene);
    INFO(text_of(found));
    CHECK(found.report.terminals.size() == 4);
    REQUIRE(found.report.productions.size() == 1);
    CHECK(found.grammar.productions.front().parameters.size() == 1);
    CHECK(found.grammar.exceptions.empty());
}

TEST_CASE("one of another colour in a row is an exception") {
    const Scene scene = tinted_scene("axiom: R(16)\nR(m) : m > 0 -> [;(1 + (m == 6)) A] f(3) R(m-1)", {{"A", hook()}}, 2);
    const Analysis found = analysed(scene);
    INFO(text_of(found));
    CHECK(rules_in_words(found.report) == "sequence of 16");
    CHECK(found.report.terminals.size() == 1);
    CHECK(found.grammar.exceptions.size() <= 1);
}

TEST_CASE("colours without order do not break up a grid") {
    Random random(5);
    Scene scene = tinted_scene("axiom: G(8)\nG(m) : m > 0 -> [R(9)] f(3) G(m-1)\nR(m) : m > 0 -> [;(1) A] +(90) f(3) -(90) R(m-1)",
                               {{"A", rectangle(2, 2.5)}}, 4);
    for (Element& element : scene.elements) element.style = filled(shade(1 + static_cast<int>(random.below(4))));
    const Analysis found = analysed(scene);
    INFO(text_of(found));
    CHECK(found.report.productions.size() == 2);
    CHECK(found.report.terminals.size() == 1);
    CHECK(found.report.grammar_bits < 0.5 * found.report.drawing_bits);
}
