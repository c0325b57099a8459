#include <catch2/catch.hpp>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "analyzer/analyze.h"
#include "analyzer/rule_comment.h"
#include "analyzer/rule_sets.h"
#include "analyzer/symbol_names.h"
#include "closed_loop/known_grammar.h"
#include "closed_loop/shapes.h"
#include "lsystem/parse_statement.h"
#include "lsystem/turtle_commands.h"

using namespace rinceau;
using namespace rinceau::test;

namespace {

/// What a rule on this many hooks is called, and what is said of it.
struct Words {
    std::string name;
    std::string comment;
};

Words words_of(const Rule& rule, int count) {
    std::vector<Similarity> poses = repetition_poses(rule, count);
    for (Similarity& pose : poses) pose = translate({5, 5}) * scale_by(2) * pose;
    const RuleSet rules = grouped(copies(cyclic(1), poses), rule);
    const std::vector<RuleUse> uses = rule_uses(rules, root_items(rules));
    return {rule_name(rules, rules.parts.back(), uses), rule_comment(rules, rules.parts.back(), {"A", ""}, uses)};
}

Words words_of_steps(const Similarity& step, int count) {
    return words_of({.kind = RuleKind::sequence, .repeated = 0, .step = step}, count);
}

std::vector<std::string> names_for_ids(const std::vector<std::vector<std::string>>& ids_of_looks) {
    Scene scene;
    Instancing instancing;
    for (const auto& ids : ids_of_looks) {
        for (const std::string& id : ids) {
            scene.elements.push_back({.id = id});
            instancing.instances.push_back({.look = static_cast<int>(instancing.looks.size())});
        }
        instancing.looks.emplace_back();
    }
    return look_names(instancing, scene);
}

}  // namespace

TEST_CASE("what looks have no name in the drawing get letters, all different") {
    std::set<std::string> names;
    for (int index = 0; index < 200; ++index) CHECK(names.insert(terminal_letter(index)).second);
    CHECK(terminal_letter(0) == "A");
    CHECK(terminal_letter(26) == "A1");
    CHECK(names_for_ids({{""}, {"path12"}, {"SVGID_1_"}, {"x1"}}) == std::vector<std::string>{"A", "B", "C", "D"});
}

TEST_CASE("looks are called what the drawing calls all of their elements") {
    CHECK(names_for_ids({{"window-1", "window-2"}, {"rect1", "door"}, {"roof"}}) == std::vector<std::string>{"Window", "A", "Roof"});
    CHECK(names_for_ids({{"leaf1"}, {"leaf2", "leaf3"}}) == std::vector<std::string>{"Leaf", "Leaf2"});
    CHECK(names_for_ids({{"lsystem-Shutter"}}) == std::vector<std::string>{"Shutter"});
    // Ids are anyone's text.
    CHECK(names_for_ids({{"\"><"}, {"häuser"}, {"a b c 12 d"}, {std::string(500, 'a')}}) == std::vector<std::string>{"A", "B", "C", "D"});
}

TEST_CASE("a straight sequence is named by how it lies in the drawing") {
    CHECK(words_of_steps(translate({3, 0}), 7).name == "Row");
    CHECK(words_of_steps(translate({-3, 0.5}), 7).name == "Row");
    CHECK(words_of_steps(translate({0, 3}), 7).name == "Column");
    CHECK(words_of_steps(translate({0.2, -3}), 7).name == "Column");
    CHECK(words_of_steps(translate({3, 3}), 7).name == "Diagonal");
    CHECK(words_of_steps(translate({3, 0}), 7).comment == "a row of 7 A, 6 apart");
}

TEST_CASE("rules are told apart in words") {
    CHECK(kind_name(RuleKind::ring) == "ring");
    const auto spiral = words_of_steps(translate({0, 3}) * rotate(radians(20)) * scale_by(0.9), 7);
    CHECK(spiral.name == "Spiral");
    CHECK(spiral.comment == "a spiral of 7 A, turning by 20 degrees, each 0.9 times as large");
    CHECK(words_of_steps(translate({0, 3}) * rotate(0.3), 5).name == "Arc");
    CHECK(words_of_steps(translate({0, 0.1}) * rotate(0.3), 5).name == "Fan");
    CHECK(words_of_steps(translate({0, 3}) * rotate(0.3), 2).name == "Pair");
    CHECK(words_of_steps(scale_by(0.8), 5).name == "Nest");
    CHECK(words_of_steps(translate({0, 3}) * scale_by(0.8), 5).name == "Taper");
    CHECK(words_of_steps(translate({0, 3}) * mirror_about_heading(), 9).name == "Zigzag");
    CHECK(words_of_steps(translate({3, 0}) * mirror_about_heading(), 2).comment == "a mirrored pair of A");
    const Words ring = words_of({.kind = RuleKind::ring, .repeated = 0, .step = translate({0, 4}) * rotate(two_pi / 12)}, 12);
    CHECK(ring.name == "Ring");
    CHECK(ring.comment.find("a ring of 12 A, radius 15.") == 0);  // 2 * 4 / (2 sin 15 degrees)
}

TEST_CASE("the symbols of a grammar are all different and none is a word of the language") {
    const auto window = [](const std::string& id, Point at) {
        Element copy = placed(element(rectangle(7, 9), filled({1, 2, 3})), translate(at));
        copy.id = id;
        return copy;
    };
    // Rows of things that are called as their rule would be.
    Scene scene;
    for (int k = 0; k < 30; ++k) scene.elements.push_back(window("row-" + std::to_string(k), {13.0 * (k % 6), 20.0 * (k / 6)}));
    for (int k = 0; k < 8; ++k) {
        scene.elements.push_back(placed(element(hook(), filled({9, 0, 0})), translate({300, 50}) * rotate(pi / 4 * k) * translate({0, 60}) * scale_by(5)));
        scene.elements.back().id = "Ring_count";
    }
    for (const Element& e : scene.elements) scene.viewport = including(scene.viewport, painted_box(e));
    const Grammar grammar = analyze(scene).grammar;
    std::set<std::string> names;
    for (const Terminal& terminal : grammar.terminals) CHECK(names.insert(terminal.symbol).second);
    for (const Production& production : grammar.productions) CHECK(names.insert(production.symbol).second);
    for (const Constant& constant : grammar.constants) CHECK(names.insert(constant.name).second);
    for (const std::string& name : names) {
        CHECK(find_turtle_command(name) == nullptr);
        CHECK(std::ranges::count(statement_words(), name) == 0);
    }
    CHECK(names.count("Row") == 1);
    CHECK(names.count("Grid") == 1);
    CHECK(grammar.terminals.front().symbol == "Row");
}

TEST_CASE("names are given from the top down") {
    const Scene scene = drawn_scene(known_grammar(
        "axiom: Q(4)\nQ(m) : m > 0 -> [-(90) P(5)] f(90) Q(m-1)\nP(m) : m > 0 -> [S(7)] f(100) P(m-1)\nS(m) : m > 0 -> [A] f(12) S(m-1)",
        {{"A", element(hook(), filled({1, 2, 3}))}}));
    const Grammar grammar = analyze(scene).grammar;
    REQUIRE(grammar.productions.size() == 3);
    // Every rule stands below those that use it.
    for (std::size_t k = 0; k < grammar.productions.size(); ++k) {
        for (std::size_t below = k + 1; below < grammar.productions.size(); ++below) {
            CHECK(std::ranges::count(grammar.productions[below].successor, grammar.productions[k].symbol, &ModuleTemplate::symbol) == 0);
        }
    }
    CHECK(grammar.productions[0].symbol == "Grid");
    CHECK(grammar.productions[0].comment == "a grid of 4 Row, 90 apart");
    CHECK(grammar.productions[1].symbol == "Row");
    CHECK(grammar.productions[2].symbol == "Row2");
}

TEST_CASE("rows of things that look the same when turned are written without turns") {
    // Hexagons, each in another of its six equal poses.
    Scene scene;
    Random random(3);
    for (int k = 0; k < 24; ++k) {
        const Similarity turned = rotate(two_pi / 6 * random.below(6));
        scene.elements.push_back(placed(element(regular_polygon(6, 5), filled({1, 2, 3})), translate({14.0 * (k % 6), 20.0 * (k / 6)}) * turned));
        scene.viewport = including(scene.viewport, painted_box(scene.elements.back()));
    }
    const Grammar grammar = analyze(scene).grammar;
    REQUIRE(grammar.productions.size() == 2);
    for (const Production& production : grammar.productions) {
        for (const ModuleTemplate& module : production.successor) {
            if (module.symbol != "+" && module.symbol != "-") continue;
            CHECK(to_text(module.arguments[0]) == "90");  // to the side and back
        }
    }
}
