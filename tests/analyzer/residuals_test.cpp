#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

#include "analyzer/analyze.h"
#include "analyzer/generate_rules.h"
#include "analyzer/grammar_bits.h"
#include "analyzer/group_residuals.h"
#include "analyzer/order_rules.h"
#include "closed_loop/scenes.h"
#include "closed_loop/shapes.h"
#include "lsystem/interpret.h"

using namespace rinceau;
using namespace rinceau::test;

namespace {

constexpr double pitch = 30;
constexpr double fine = 1e-5;  // slack of the numbers of a grammar, scene length

/// Squares of side 10 in rows and columns.
Scene lattice(int columns, int rows) {
    Scene scene;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            scene.elements.push_back(placed(element(rectangle(10, 10), filled({})), translate({pitch * column, pitch * row})));
        }
    }
    scene.viewport = {{-20, -20}, {pitch * columns, pitch * rows}};
    return scene;
}

struct Found {
    Instancing instancing;
    OrderedRules ordered;
    WrittenGrammar written;
    double diagonal = 1;
};

Found found_in(const Scene& scene) {
    Found found;
    found.diagonal = drawing_diagonal(scene);
    found.instancing = group_similar_elements(scene);
    const SearchState state = generate_rules(starting_state(found.instancing, {}, found.diagonal), {});
    found.ordered = ordered_for_painting(state.rules, {});
    found.written = to_grammar(found.ordered, found.instancing, scene, fine);
    return found;
}

DescriptionBits bits_of(const Found& found) {
    const Residuals exact = with_residuals(found.written, found.instancing, 1e-3);
    return description_bits(found.ordered, found.written, exact.grammar, found.instancing, {exact.left_over, exact.groups},
                            found.diagonal);
}

}  // namespace

TEST_CASE("a drawing that is exactly its rule needs no exceptions") {
    const Found found = found_in(lattice(12, 1));
    REQUIRE(found.written.grammar.productions.size() == 1);
    const Residuals exact = with_residuals(found.written, found.instancing, 1e-3);
    CHECK(exact.exceptions == 0);
    CHECK(exact.grammar.exceptions.empty());
    REQUIRE(exact.deviation.size() == 12);
    for (const double deviation : exact.deviation) CHECK(deviation < 1e-3);
}

TEST_CASE("only elements that are off by more than the tolerance get an exception, which puts them where they are drawn") {
    const Found found = found_in(lattice(12, 1));
    // The rule stays; the drawing has two elements elsewhere, a third one hardly.
    Instancing moved = found.instancing;
    moved.instances[3].pose.translation += Point{0.4, -0.3};
    moved.instances[7].pose = moved.instances[7].pose * rotate(0.1);
    moved.instances[9].pose.translation += Point{1e-3, 0};
    constexpr double tolerance = 1e-2;
    const Residuals exact = with_residuals(found.written, moved, tolerance);
    CHECK(exact.exceptions == 2);
    CHECK(exact.grammar.exceptions.size() == 2);

    const std::vector<Placement> before = interpret(found.written.grammar), after = interpret(exact.grammar);
    REQUIRE(after.size() == 12);
    int changed = 0;
    for (std::size_t leaf = 0; leaf < after.size(); ++leaf) {
        const auto element = static_cast<std::size_t>(found.written.element_of_leaf[leaf]);
        CHECK(abs(after[leaf].pose.translation - moved.instances[element].pose.translation) < tolerance);
        CHECK((exact.deviation[leaf] > tolerance) == (element == 3 || element == 7));
        changed += after[leaf].pose == before[leaf].pose ? 0 : 1;
    }
    CHECK(changed == 2);
}

TEST_CASE("a symmetric element that is turned into itself is not off") {
    const Found found = found_in(lattice(12, 1));
    Instancing turned = found.instancing;
    turned.instances[5].pose = turned.instances[5].pose * rotate(pi / 2);
    CHECK(with_residuals(found.written, turned, 1e-2).exceptions == 0);
}

TEST_CASE("a lattice costs far less than its elements, and a larger one hardly more") {
    const DescriptionBits small = bits_of(found_in(lattice(10, 10))), large = bits_of(found_in(lattice(20, 20)));
    CHECK(small.grammar < 0.2 * small.drawing);
    CHECK(large.grammar < 0.05 * large.drawing);
    CHECK(large.drawing > 3.5 * small.drawing);
    CHECK(large.grammar < 1.5 * small.grammar);
}

TEST_CASE("the list of all elements costs what the drawing costs, and deviations cost more") {
    const Scene scene = clutter_scene(60).scene;
    Found found = found_in(scene);
    REQUIRE(found.written.grammar.productions.empty());
    const DescriptionBits flat = bits_of(found);
    CHECK(flat.drawing > 0);
    CHECK(flat.grammar == Approx(flat.drawing));

    const Found row = found_in(lattice(30, 1));
    Instancing shaken = row.instancing;
    for (std::size_t i = 0; i < shaken.instances.size(); i += 3) shaken.instances[i].pose.translation += Point{0.3, 0};
    const Residuals exact = with_residuals(row.written, shaken, 1e-3);
    const DescriptionBits rough = description_bits(row.ordered, row.written, exact.grammar, row.instancing,
                                                   {exact.left_over, exact.groups}, row.diagonal);
    CHECK(rough.grammar > bits_of(row).grammar + 10);
}

TEST_CASE("bits do not depend on the unit of length") {
    const Scene scene = lattice(9, 7);
    const auto in_unit = [&](double unit) {
        Scene other;
        for (const Element& element : scene.elements) other.elements.push_back(placed(element, scale_by(unit)));
        other.viewport = {unit * scene.viewport.low, unit * scene.viewport.high};
        return analyze(other).report;
    };
    // Whole numbers cost less than others: neither unit makes them.
    const AnalysisReport small = in_unit(1.2345), large = in_unit(34.567);
    CHECK(small.drawing_bits == Approx(large.drawing_bits));
    CHECK(small.grammar_bits == Approx(large.grammar_bits).epsilon(0.02));
}
