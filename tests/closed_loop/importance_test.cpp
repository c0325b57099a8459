// The paper's importance function, and what its weights do (Stava et al. 2010, section 5.4 and Figure 7).

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>
#include <vector>

#include "closed_loop/findings.h"
#include "closed_loop/known_grammar.h"
#include "closed_loop/recipe.h"
#include "closed_loop/scenes.h"

using namespace rinceau;
using namespace rinceau::test;

namespace {

constexpr double tolerance = 0.02;  // of the elements' sizes

/// As Figure 7: two columns of three that stand close together, but not quite in a line, or three rows of two that are far apart
/// but exactly alike.
Scene figure_7() {
    constexpr double size = 5, aside = 1.5 * tolerance * 3;  // the hook's rms radius is some 3
    Scene scene;
    const Element mark = sized(hook(), size, filled(ink));
    for (const double x : {0.0, 40.0}) {
        for (const int row : {0, 1, 2}) {
            scene.elements.push_back(placed(mark, translate({x + (row == 1 ? aside : 0), 13.0 * row})));
            scene.viewport = including(scene.viewport, painted_box(scene.elements.back()));
        }
    }
    Random random(7);
    return shuffled(scene, random);
}

Analysis grouped_by(const ImportanceWeights& weights, Objective objective) {
    return analyze(figure_7(), {.tolerance = tolerance, .weights = weights, .objective = objective});
}

/// Is there a rule that makes sequences of `length`, `instances` of them?
bool has_sequences(const Analysis& found, int length, int instances) {
    return std::ranges::any_of(found.report.productions, [&](const ProductionReport& production) {
        return production.kind == "sequence" && production.lengths == std::vector<int>{length} && production.instances == instances;
    });
}

void check_two_groupings(const ImportanceWeights& near, const ImportanceWeights& alike, Objective objective) {
    const Analysis columns = grouped_by(near, objective);
    INFO("near: " << rules_in_words(columns.report));
    CHECK(has_sequences(columns, 3, 2));
    const Analysis rows = grouped_by(alike, objective);
    INFO("alike: " << rules_in_words(rows.report));
    CHECK(has_sequences(rows, 2, 3));
}

}  // namespace

TEST_CASE("Fig. 7: nearness makes two sequences, similarity three") {
    check_two_groupings({0.2, 1, 0, 0}, {0.2, 0, 1, 0}, Objective::paper);  // of equals, the one that repeats more
}

TEST_CASE("Fig. 7: the weights do the same where bits decide") {
    check_two_groupings({1, 4, 0, 1}, {1, 0, 4, 1}, Objective::bits);
}

TEST_CASE("importance is the weighted sum of eq. 5, counts as shares of the largest") {
    const ImportanceTerms terms{6, 0.5, 1, 3}, largest{12, 1, 1, 6};
    CHECK(importance(terms, largest, {1, 0, 0, 0}) == Approx(0.5));
    CHECK(importance(terms, largest, {0, 1, 0, 0}) == Approx(0.5));
    CHECK(importance(terms, largest, {0, 0, 1, 0}) == Approx(1));
    CHECK(importance(terms, largest, {0, 0, 0, 1}) == Approx(0.5));
    CHECK(importance(terms, largest, {2, 1, 1, 4}) == Approx(1 + 0.5 + 1 + 2));
    CHECK(importance(terms, largest, {1, 1, 1, 1}) <= greatest_importance({1, 1, 1, 1}));
}

TEST_CASE("the paper's objective joins whatever repeats, even clutter, and still draws the drawing") {
    const Scene scene = clutter_scene(40).scene;
    const Analysis found = analyze(scene, {.objective = Objective::paper});
    CHECK(found.report.objective == Objective::paper);
    CHECK(found.report.check.passed);
    CHECK(found.report.productions.size() > 5);
    CHECK(found.report.grammar_bits > found.report.drawing_bits);
    CHECK(analyze(scene).report.productions.empty());
}
