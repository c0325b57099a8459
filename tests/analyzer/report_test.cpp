#include <catch2/catch.hpp>

#include <algorithm>
#include <string>

#include "analyzer/analyze.h"
#include "closed_loop/shapes.h"

using namespace rinceau;
using namespace rinceau::test;

namespace {

/// A row of 12 hooks, every second one mirrored, a lattice of 6 x 5 squares, a ring of 9 circles, and a piece of text.
Scene assorted() {
    Scene scene;
    const auto add = [&](const Element& element, const Similarity& pose) { scene.elements.push_back(placed(element, pose)); };
    Similarity pose = translate({0, 300});
    for (int k = 0; k < 12; ++k, pose = pose * translate({0, 25}) * mirror_about_heading()) {
        add(element(transformed(hook(), translate({1, 0})), filled({1, 0, 0})), rotate(-pi / 2) * pose * scale_by(5));
    }
    for (int k = 0; k < 30; ++k) add(element(rectangle(10, 10), filled({2, 0, 0})), translate({17.0 * (k % 6), 19.0 * (k / 6)}));
    for (int k = 0; k < 9; ++k) {
        add(element(circle(4), filled({3, 0, 0})), translate({250, 50}) * rotate(two_pi * k / 9) * translate({0, 40}));
    }
    Element text;
    text.verbatim = "<text x=\"400\" y=\"0\">A</text>";
    text.verbatim_box = {{400, 0}, {410, 10}};
    scene.elements.push_back(text);
    for (const Element& e : scene.elements) scene.viewport = including(scene.viewport, painted_box(e));
    return scene;
}

}  // namespace

TEST_CASE("a report counts what the drawing has") {
    const Scene scene = assorted();
    const AnalysisReport report = analyze(scene).report;
    CHECK(report.elements == static_cast<int>(scene.elements.size()));
    CHECK(report.verbatim == 1);
    int instances = 0;
    for (const TerminalReport& terminal : report.terminals) instances += terminal.instances;
    CHECK(instances == report.elements);
    const auto terminal_of = [&](int count) {
        const auto found = std::ranges::find(report.terminals, count, &TerminalReport::instances);
        REQUIRE(found != report.terminals.end());
        return *found;
    };
    CHECK(terminal_of(12).symmetry == 1);
    CHECK(terminal_of(12).mirrored == 6);
    CHECK(terminal_of(30).symmetry == 4);
    CHECK(terminal_of(30).mirrored == 0);
    CHECK(terminal_of(9).symmetry == 0);
}

TEST_CASE("a report tells of every production what a person would say") {
    const Analysis found = analyze(assorted());
    const AnalysisReport& report = found.report;
    REQUIRE(report.productions.size() == found.grammar.productions.size());
    for (std::size_t k = 0; k < report.productions.size(); ++k) {
        const ProductionReport& production = report.productions[k];
        INFO(production.body);
        CHECK(production.symbol == found.grammar.productions[k].symbol);
        CHECK(production.body.rfind(production.symbol, 0) == 0);
        CHECK(production.body.find(" -> ") != std::string::npos);
        CHECK_FALSE(production.lengths.empty());
        CHECK(std::ranges::is_sorted(production.lengths));
        CHECK(production.instances >= 1);
    }
    const auto has = [&](const std::string& kind, int length, int instances) {
        return std::ranges::any_of(report.productions, [&](const ProductionReport& p) {
            return p.kind == kind && p.lengths == std::vector{length} && p.instances == instances;
        });
    };
    CHECK(has("ring", 9, 1));
    CHECK(has("sequence", 12, 1));
    // The lattice: rows of columns or columns of rows.
    CHECK(((has("sequence", 6, 5) && has("sequence", 5, 1)) || (has("sequence", 5, 6) && has("sequence", 6, 1))));
}

TEST_CASE("a report's axiom and proof are those of the grammar") {
    const Analysis found = analyze(assorted());
    CHECK(found.report.check.passed);
    CHECK(found.report.check.elements == found.report.elements);
    CHECK(found.report.grammar_bits < found.report.drawing_bits);
    CHECK(found.report.tolerance > 0);
    for (const ModuleTemplate& module : found.grammar.axiom) CHECK(found.report.axiom.find(module.symbol) != std::string::npos);
}

TEST_CASE("an empty drawing is an empty grammar") {
    const Analysis found = analyze(Scene{{{0, 0}, {10, 10}}, true, {}});
    CHECK(found.report.check.passed);
    CHECK(found.report.elements == 0);
    CHECK(found.grammar.axiom.empty());
    CHECK(found.report.productions.empty());
}

TEST_CASE("weights steer, they never make rules of chance nor break the drawing") {
    const Scene scene = assorted();
    for (const ImportanceWeights& weights : {ImportanceWeights{0, 0, 0, 0}, ImportanceWeights{4, 0, 1, 1}, ImportanceWeights{1, 4, 0, 4}, ImportanceWeights{4, 4, 4, 4}}) {
        const Analysis found = analyze(scene, {.weights = weights});
        CHECK(found.report.check.passed);
        CHECK(found.report.grammar_bits < found.report.drawing_bits);
    }
    Scene chance;
    Random random(1);
    for (int k = 0; k < 200; ++k) {
        chance.elements.push_back(placed(element(hook(), filled({})), {polar(random.uniform(0.5, 2), random.uniform(-pi, pi)),
                                                                       {random.uniform(0, 100), random.uniform(0, 100)}, false}));
        chance.viewport = including(chance.viewport, painted_box(chance.elements.back()));
    }
    for (const ImportanceWeights& weights : {ImportanceWeights{0, 0, 0, 0}, ImportanceWeights{4, 4, 4, 4}}) {
        CHECK(analyze(chance, {.weights = weights}).report.productions.empty());
    }
}
