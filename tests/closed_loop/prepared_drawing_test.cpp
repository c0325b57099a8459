#include <catch2/catch.hpp>

#include <string>
#include <vector>

#include "analyzer/analyze.h"
#include "closed_loop/scenes.h"
#include "lsystem/grammar_text.h"

using namespace rinceau;
using namespace rinceau::test;

namespace {

/// One with everything (rows, rings, clutter) and one without any rule.
std::vector<Scene> some_scenes() { return {nested_scene(1, 1).scene, clutter_scene(150).scene}; }

std::vector<AnalyzeOptions> some_preferences() {
    return {{},
            {.weights = {.count = 2, .nearness = 0.5}},
            {.weights = {.nearness = 4}},
            {.weights = {.count = 0}},
            {.objective = Objective::paper}};
}

}  // namespace

TEST_CASE("What was prepared once gives the same grammar as all from the beginning, whatever is preferred") {
    for (const Scene& scene : some_scenes()) {
        const PreparedDrawing prepared = prepare_drawing(scene);
        for (const AnalyzeOptions& options : some_preferences()) {
            const Analysis again = analyze(prepared, options);
            const Analysis afresh = analyze(scene, options);
            CHECK(to_text(again.grammar) == to_text(afresh.grammar));
            CHECK(again.report.grammar_bits == afresh.report.grammar_bits);
            CHECK(again.report.check.max_deviation == afresh.report.check.max_deviation);
        }
    }
}

TEST_CASE("Any number of threads gives the same bytes") {
    for (const Scene& scene : some_scenes()) {
        const Analysis one = analyze(scene, {.threads = 1});
        for (const int threads : {2, 3}) {
            const Analysis many = analyze(scene, {.threads = threads});
            CHECK(to_text(many.grammar) == to_text(one.grammar));
            CHECK(many.report.check.rms_deviation == one.report.check.rms_deviation);
        }
    }
}
