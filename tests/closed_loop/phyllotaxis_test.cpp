// Spirals of the power law r = c m^p, drawn, rounded, shuffled and analysed.

#include <catch2/catch.hpp>

#include <cmath>
#include <string>

#include "closed_loop/findings.h"
#include "closed_loop/known_grammar.h"
#include "closed_loop/shapes.h"
#include "lsystem/grammar_text.h"

using namespace rinceau;
using namespace rinceau::test;

namespace {

const double golden_angle = 360 * (1 - 2 / (1 + std::sqrt(5.0)));

Element seed() { return element(circle(3), filled({200, 120, 0})); }
Element curl() { return element(transformed(hook(), scale_by(6)), filled({0, 120, 200})); }

/// The scene in 1e-3 of its elements' size and in random order.
Scene as_drawn(const Scene& exact) {
    Random random(5);
    return shuffled(rounded(exact, 1e-3), random);
}

/// The angle from one index to the next that the only production turns by, in degrees.
double found_angle(const Grammar& grammar) {
    for (const ModuleTemplate& module : grammar.productions.front().successor) {
        const double sense = module.symbol == "+" ? 1 : module.symbol == "-" ? -1 : 0;
        if (sense != 0) return std::fmod(sense * module.arguments.front().postfix.front().number + 360, 360);
    }
    return 0;
}

/// Counted the other way round, or with the mirror image's sense.
double angle_error(double found, double wanted) {
    return std::min(std::abs(found - wanted), std::abs(360 - found - wanted));
}

void check_one_spiral(const Scene& scene, int members, double angle) {
    const Analysis found = analyze(scene);
    INFO(to_text(found.grammar).substr(0, 1000));
    CHECK(found.report.check.passed);
    CHECK(rules_in_words(found.report) == "spiral of " + std::to_string(members));
    CHECK(axiom_symbols(found.grammar) == 1);
    CHECK(found.grammar.exceptions.empty());
    REQUIRE(found.grammar.productions.size() == 1);
    CHECK(angle_error(found_angle(found.grammar), angle) < 1e-6 * angle);
}

}  // namespace

TEST_CASE("a flower head of a thousand seeds is one rule with the golden angle") {
    const Grammar known =
        known_grammar("axiom: P(1000)\nP(m) : m > 0 -> P(m-1) [+(137.50776405*m) f(14*m^0.5) A]", {{"A", seed()}});
    check_one_spiral(as_drawn(drawn_scene(known)), 1000, golden_angle);
}

TEST_CASE("a flower head is found when its radii are uneven by up to a tenth of what they grow by") {
    for (const double share : {0.01, 0.05, 0.1}) {
        Random random(11);
        Scene scene;
        for (int m = 1; m <= 300; ++m) {
            const double growth = 20 * (std::sqrt(m + 1.0) - std::sqrt(m));
            const double radius = 20 * std::sqrt(m) + random.uniform(-share, share) * growth;
            scene.elements.push_back(placed(seed(), translate(polar(radius, radians(golden_angle * m)))));
            scene.viewport = including(scene.viewport, painted_box(scene.elements.back()));
        }
        const Analysis found = analyze(scene);
        INFO(share << "\n" << to_text(found.grammar).substr(0, 600));
        CHECK(found.report.check.passed);
        CHECK(rules_in_words(found.report) == "spiral of 300");
        REQUIRE(found.grammar.productions.size() == 1);
        CHECK(angle_error(found_angle(found.grammar), golden_angle) < 1e-5 * golden_angle);
    }
}

TEST_CASE("a flower head may begin anywhere, and its members may turn with it, grow and stand off their places") {
    for (const char* rule : {"[+(137.5*m) f(25*m^0.5) A]", "[+(137.5*(m-1)) f(25*(m-1)^0.5) A]", "[+(137.5*(m+40)) f(25*(m+40)^0.5) A]",
                             "[+(137.5*m) f(25*m^0.5) *(1+0.004*m) +(30) A]", "[-(137.5*m) f(25*m^0.5) +(137.5*m) A]",
                             "[+(137.5*m) f(25*m^0.5) *(0.6+0.004*m) f(4) -(80) f(2) A]"}) {
        INFO(rule);
        const Grammar known = known_grammar("axiom: P(200)\nP(m) : m > 0 -> P(m-1) " + std::string(rule), {{"A", curl()}});
        check_one_spiral(as_drawn(drawn_scene(known)), 200, 137.5);
    }
}

TEST_CASE("a spiral of Archimedes and other powers are spirals, too") {
    for (const char* rule : {"[+(17*m) f(3*m) A]", "[+(23*m) f(40*m^0.4) A]", "[+(100*m) f(2*m^1.3) A]"}) {
        INFO(rule);
        const Grammar known = known_grammar("axiom: P(120)\nP(m) : m > 0 -> P(m-1) " + std::string(rule), {{"A", seed()}});
        const Analysis found = analyze(as_drawn(drawn_scene(known)));
        INFO(to_text(found.grammar).substr(0, 600));
        CHECK(rules_in_words(found.report) == "spiral of 120");
    }
}

TEST_CASE("other things among the seeds leave the flower head one rule") {
    const Grammar known = known_grammar(
        "axiom: P(400) [f(700) B] [+(90) f(650) A] [-(100) f(640) A]\nP(m) : m > 0 -> P(m-1) [+(137.5*m) f(25*m^0.5) A]",
        {{"A", seed()}, {"B", element(star(5), filled({9, 9, 9}))}});
    const Analysis found = analyze(as_drawn(drawn_scene(known)));
    INFO(to_text(found.grammar).substr(0, 600));
    CHECK(rules_in_words(found.report) == "spiral of 400");
    CHECK(axiom_symbols(found.grammar) == 4);
}
