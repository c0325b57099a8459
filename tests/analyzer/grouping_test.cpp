#include "analyzer/grouping.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "analyzer/analyze.h"
#include "closed_loop/shapes.h"
#include "lsystem/interpret.h"
#include "lsystem/to_scene.h"

using namespace rinceau;
using namespace rinceau::test;

namespace {

constexpr int columns = 6;

/// A row of hooks under a row of leaves.
Scene two_rows() {
    Scene scene{{{-10, -10}, {100, 60}}, true, {}};
    for (int k = 0; k < columns; ++k)
        scene.elements.push_back(placed(element(hook(), filled({})), translate({14.0 * k, 0}) * scale_by(4)));
    for (int k = 0; k < columns; ++k)
        scene.elements.push_back(placed(element(leaf(), filled({})), translate({14.0 * k, 30}) * scale_by(4)));
    return scene;
}

std::vector<int> range(int first, int last) {
    std::vector<int> elements;
    for (int k = first; k < last; ++k) elements.push_back(k);
    return elements;
}

Analysis analysed(const std::vector<GroupingWish>& wishes) {
    AnalyzeOptions options;
    options.grouping = wishes;
    return analyze(two_rows(), options);
}

}  // namespace

TEST_CASE("elements that shall be together share a terminal, drawn as the first, each in its place") {
    const Scene scene = two_rows();
    const Analysis found = analysed({{GroupingKind::together, range(0, 2 * columns)}});
    CHECK(found.report.check.passed);
    CHECK(found.grammar.terminals.size() == 1);
    CHECK_FALSE(found.report.warnings.empty());
    const Scene drawn = to_scene(found.grammar, interpret(found.grammar));
    REQUIRE(drawn.elements.size() == scene.elements.size());
    const Instancing copies = group_similar_elements(drawn);
    CHECK(copies.looks.size() == 1);
    const auto middle = [](const Element& each) {
        const Box box = bounds(each.paths);
        return 0.5 * (box.low + box.high);
    };
    for (const Element& meant : scene.elements) {
        constexpr double half_an_element = 2;
        CHECK(std::ranges::any_of(drawn.elements,
                                  [&](const Element& each) { return abs(middle(each) - middle(meant)) < half_an_element; }));
    }
}

TEST_CASE("elements that shall be apart have a terminal of their own, and the picture is the same") {
    CHECK(analysed({}).grammar.terminals.size() == 2);
    const Analysis found = analysed({{GroupingKind::apart, {2, 3}}});
    CHECK(found.report.check.passed);
    REQUIRE(found.grammar.terminals.size() == 3);
    CHECK(std::ranges::count(found.report.terminals, 2, &TerminalReport::instances) == 1);
    CHECK(found.report.warnings.empty());
}

TEST_CASE("a whole group is apart from the rest already") {
    CHECK(analysed({{GroupingKind::apart, range(0, columns)}}).grammar.terminals.size() == 2);
}

TEST_CASE("the later wish about an element holds") {
    const GroupingWish together{GroupingKind::together, range(0, 2 * columns)};
    const GroupingWish apart{GroupingKind::apart, range(columns, 2 * columns)};
    const std::vector<GroupingWish> wishes = effective_wishes(std::vector{together, apart});
    REQUIRE(wishes.size() == 2);
    CHECK(wishes[0].elements == range(0, columns));
    CHECK(effective_wishes(std::vector{apart, together}) == std::vector{together});
    CHECK(analysed({together, apart}).report.warnings.empty());
    CHECK(analysed({apart, together}).grammar.terminals.size() == 1);
}

TEST_CASE("wishes about elements that there are not are passed over") {
    CHECK(analysed({{GroupingKind::together, {-1, 99}}, {GroupingKind::apart, {1000}}}).grammar.terminals.size() == 2);
}

TEST_CASE("elements that are alone are drawn exactly as they are") {
    Scene scene = two_rows();
    const Instancing copies = group_similar_elements(scene);
    scene.elements[3].paths.front().start.x += 0.01;
    const std::vector<int> alone{3};
    const Instancing found = with_lone_elements(copies, scene, alone);
    REQUIRE(found.looks.size() == copies.looks.size() + 1);
    const Instance& instance = found.instances[3];
    const Look& own = found.looks[static_cast<std::size_t>(instance.look)];
    CHECK(std::ranges::count(found.instances, instance.look, &Instance::look) == 1);
    CHECK(own.shape != copies.looks.front().shape);
    const Path drawn = transformed(own.paths, instance.pose).front();
    CHECK(abs(drawn.start - scene.elements[3].paths.front().start) < 1e-9);
}

TEST_CASE("what a list of copies would not redraw is nobody's copy, and the rules for the rest stay") {
    // Hard edges of colour, in the last of the tiles half a unit further on: alike as looks are, seen all the same.
    constexpr double size = 160;
    Gradient edge;
    edge.kind = GradientKind::linear;
    edge.stops = {{0, {255, 0, 0}, 1}, {0.5, {255, 0, 0}, 1}, {0.5, {0, 0, 255}, 1}, {1, {0, 0, 255}, 1}};
    Scene scene{{{-100, -100}, {1000, 100}}, true, {}};
    for (int k = 0; k < columns; ++k) {
        Element tile = element(rectangle(size, size), filled({}));
        edge.map = {size, 0, 0, size, -size / 2 + (k + 1 == columns ? 0.5 : 0), 0};
        tile.style.fill = std::make_shared<const Gradient>(edge);
        scene.elements.push_back(placed(tile, translate({170.0 * k, 0})));
    }
    REQUIRE(group_similar_elements(scene).looks.size() == 1);
    REQUIRE_FALSE(analyze(prepare_drawing(scene)).report.check.passed);
    const Analysis found = analyze(scene);
    CHECK(found.report.check.passed);
    CHECK(found.grammar.terminals.size() == 2);
    CHECK(found.report.productions.size() == 1);
}
