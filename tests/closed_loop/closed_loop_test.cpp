// Known grammar -> drawing, its coordinates rounded and its elements shuffled -> analysis -> the same grammar.

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>
#include <vector>

#include "closed_loop/findings.h"
#include "closed_loop/known_grammar.h"
#include "closed_loop/random_grammar.h"
#include "closed_loop/scenes.h"
#include "lsystem/grammar_text.h"

using namespace rinceau;
using namespace rinceau::test;

namespace {

constexpr double rounding = 1e-3;  // of element sizes, as drawing programs write coordinates

void check_found_again(SampleKind kind, const std::vector<std::uint64_t>& seeds) {
    for (const std::uint64_t seed : seeds) {
        const KnownGrammar known = random_known_grammar(kind, seed);
        const Scene exact = drawn_scene(known.grammar);
        Random random(seed);
        const Analysis found = analyze(shuffled(rounded(exact, rounding), random));
        INFO("seed " << seed << "\n" << to_text(known.grammar) << to_text(found.grammar));
        CHECK(found.report.check.passed);
        CHECK(rules_in_words(found.report) == rules_in_words(known));
        CHECK(axiom_symbols(found.grammar) == 1);
        CHECK(found.report.grammar_bits < found.report.drawing_bits);
        // The parameters are those of before the rounding if the grammar draws what was there before it.
        double smallest = diagonal(exact.viewport);
        for (const Element& element : exact.elements) smallest = std::min(smallest, diagonal(bounds(element.paths)));
        const double picture = drawing_diagonal(exact);
        const Verification check = verify(found.grammar, exact);
        CHECK(check.unmatched == 0);
        // Half a unit of the last place twice (here and in the terminal), and the digits that the grammar leaves out.
        CHECK(check.max_deviation * picture < 2 * rounding * smallest + 1e-4 * picture);
    }
}

}  // namespace

TEST_CASE("a sequence is found again") {
    check_found_again(SampleKind::sequence, {1, 3, 4, 5, 6, 7, 9, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24});
}
TEST_CASE("a linear sequence is found again") {
    check_found_again(SampleKind::linear, {1, 2, 4, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24});
}
TEST_CASE("a ring is found again") {
    check_found_again(SampleKind::ring, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24});
}
TEST_CASE("a grid is found again") {
    check_found_again(SampleKind::grid,
                      {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24});
}
TEST_CASE("a group that repeats is found again") {
    check_found_again(SampleKind::group,
                      {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24});
}
TEST_CASE("a hierarchy is found again") {
    check_found_again(SampleKind::hierarchy,
                      {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24});
}

TEST_CASE("the known drawings get no more rules and symbols than a person would need") {
    for (const KnownScene& known : scenes_but({"fig5_linear"})) {
        const Analysis found = analyze(known.scene);
        const int rules = static_cast<int>(found.report.productions.size());
        INFO(known.name << ": " << rules_in_words(found.report) << "\naxiom: " << found.report.axiom.substr(0, 300));
        INFO(found.report.check.summary);
        CHECK(found.report.check.passed);
        CHECK(rules >= known.rules);
        CHECK(rules <= known.most_rules);
        CHECK(axiom_symbols(found.grammar) <= known.axiom_symbols);
    }
}

TEST_CASE("what is found of any known drawing draws it again, in fewer bits") {
    for (const KnownScene& known : known_scenes()) {
        INFO(known.name);
        const Analysis found = analyze(known.scene);
        CHECK(found.report.check.passed);
        CHECK(found.report.check.elements == static_cast<int>(known.scene.elements.size()));
        CHECK(found.report.grammar_bits <= found.report.drawing_bits);
        CHECK(static_cast<int>(found.report.productions.size()) <= (known.rules == 0 ? 0 : known.most_rules + 2));
    }
}

TEST_CASE("chance makes no rules") {
    for (const int count : {1'000, 10'000}) {
        const Analysis found = analyze(clutter_scene(count).scene);
        INFO(count << ": " << rules_in_words(found.report));
        CHECK(found.report.productions.empty());
        CHECK(axiom_symbols(found.grammar) == count);
        CHECK(found.report.check.passed);
    }
}
