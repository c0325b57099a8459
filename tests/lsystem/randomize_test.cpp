#include "lsystem/randomize.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <catch2/catch.hpp>

#include "lsystem/check_edit.h"
#include "lsystem/grammar_text.h"
#include "lsystem/interpret.h"
#include "lsystem/numbers.h"
#include "lsystem/set_numbers.h"
#include "lsystem/symmetrize.h"
#include "random_grammar.h"

using namespace rinceau;

namespace {

const std::string leaf = "terminal A: path \"M-1 0H1V-3Z\"\nterminal B: path \"M-1 0H1V-5Z\"\n";
const std::string facade =
    "axiom: Wall(4)\nWall(m) : m > 0 -> [Row(5)] f(30) Wall(m-1)\n"
    "Row(m) : m > 0 -> [Window] -(90) f(20) +(90) Row(m-1)\nWindow -> [A] [f(2) B]\n" +
    leaf;
const std::string ring = "axiom: Ring(12)\nRing(m) : m > 0 -> [f(50) A] +(30) Ring(m-1)\n" + leaf;
const std::string tree =
    "axiom: R(4)\nR(m) : m > 0 -> A [-(17) f(64) *(0.8) -(3) R(m-1)] [+(7) f(181) *(0.6) +(23) R(m-1)]\n" + leaf;
const std::string helix = "axiom: P(40)\nP(m) : m > 0 -> A f(27.5) *(0.993) +(8.5) P(m-1)\n" + leaf;

Grammar grammar_of(const std::string& body) { return parse_grammar("lsystem 1\n" + body); }

std::string rules(const Grammar& grammar) {
    std::string text;
    for (const Production& production : grammar.productions) {
        Grammar one;
        one.productions = {production};
        const std::string whole = to_text(one);
        std::string lines = whole.substr(whole.find("\n\n") + 2);
        for (std::size_t at = lines.find("\n  "); at != std::string::npos; at = lines.find("\n  "))
            lines.replace(at, 3, " ");
        text += lines;
    }
    return text;
}

using Address = std::vector<int>;
std::map<Address, Similarity> placed(const Grammar& grammar) {
    std::map<Address, Similarity> result;
    for (const Placement& placement : interpret(grammar, {.addresses = true}))
        result.emplace(placement.address, placement.pose);
    return result;
}

Grammar set(const Grammar& grammar, const std::string& edit) {
    const NumberEdit parsed = parse_number_edit(edit);
    return set_numbers(grammar, {&parsed, 1}).grammar;
}

double heading(const Similarity& pose) { return arg(pose.linear) * 180 / pi; }

}  // namespace

TEST_CASE("noise is written where a designer expects it") {
    const RandomizeOptions options{.angle = 5, .distance = 0.1, .scale = 0.2};
    CHECK(rules(randomize(grammar_of(helix), options).grammar) ==
          "P(m) : m > 0 -> A f(27.5*(1+normal(0, 0.1))) *(0.993*exp(normal(0, 0.2))) +(8.5+normal(0, 5)) P(m-1)\n");
    CHECK(rules(randomize(grammar_of(ring), options).grammar) ==
          "Ring(m) : m > 0 -> [+(normal(0, 5)) f(50*(1+normal(0, 0.1))) *(exp(normal(0, 0.2))) A] +(30) Ring(m-1)\n");
    CHECK(rules(randomize(grammar_of(facade), options).grammar) ==
          "Wall(m) : m > 0 -> [Row(5)] f(30*(1+normal(0, 0.1))) Wall(m-1)\n"
          "Row(m) : m > 0 -> [+(normal(0, 5)) *(exp(normal(0, 0.2))) Window] -(90) f(20*(1+normal(0, 0.1))) +(90) Row(m-1)\n"
          "Window -> [A] [f(2) B]\n");
    CHECK(
        rules(randomize(grammar_of(tree), {.angle = 5}).grammar) ==
        "R(m) : m > 0 -> A [-(17) f(64) *(0.8) -(3+normal(0, 5)) R(m-1)] [+(7) f(181) *(0.6) +(23+normal(0, 5)) R(m-1)]\n");
}

TEST_CASE("a deviation of 0 gives the grammar from before, exactly") {
    for (const std::string& body : {facade, ring, tree, helix}) {
        const Grammar grammar = grammar_of(body);
        const Grammar noisy = randomize(grammar, {.angle = 5, .distance = 0.1, .scale = 0.2}).grammar;
        CHECK(to_text(noisy) != to_text(grammar));
        CHECK(to_text(randomize(noisy, {.angle = 0, .distance = 0, .scale = 0}).grammar) == to_text(grammar));
        // one kind after the other, through the text
        Grammar step = parse_grammar(to_text(noisy));
        step = parse_grammar(to_text(randomize(step, {.scale = 0}).grammar));
        step = parse_grammar(to_text(randomize(step, {.angle = 0}).grammar));
        step = randomize(step, {.distance = 0}).grammar;
        CHECK(to_text(step) == to_text(grammar));
        CHECK(to_text(without_noise(noisy)) == to_text(grammar));
    }
}

TEST_CASE("randomizing again replaces earlier noise") {
    for (const std::string& body : {facade, ring, tree, helix}) {
        const Grammar grammar = grammar_of(body);
        const Grammar once = randomize(grammar, {.angle = 7, .distance = 0.1, .scale = 0.2}).grammar;
        Grammar twice = randomize(grammar, {.angle = 3}).grammar;
        twice = randomize(twice, {.distance = 0.1, .scale = 0.2}).grammar;
        twice = randomize(twice, {.angle = 7}).grammar;
        CHECK(to_text(twice) == to_text(once));
    }
}

TEST_CASE("noise leaves every name, and can be set by its own") {
    for (const std::string& body : {facade, ring, tree, helix}) {
        const Grammar grammar = grammar_of(body);
        const Grammar noisy = randomize(grammar, {.angle = 5, .distance = 0.1, .scale = 0.2}).grammar;
        const auto names = grammar_numbers(noisy);
        for (const GrammarNumber& number : grammar_numbers(grammar)) {
            if (number.rank == NumberRank::hidden) continue;
            INFO(number.name);
            const auto same = std::ranges::find(names, number.name, &GrammarNumber::name);
            REQUIRE(same != names.end());
            CHECK(same->value == number.value);
        }
    }
    const Grammar noisy = randomize(grammar_of(ring), {.angle = 5}).grammar;
    CHECK(rules(set(noisy, "Ring.A.angle_noise=2")) == "Ring(m) : m > 0 -> [+(normal(0, 2)) f(50) A] +(30) Ring(m-1)\n");
    CHECK(rules(set(randomize(grammar_of(helix), {.angle = 5}).grammar, "P.spin=9")) ==
          "P(m) : m > 0 -> A f(27.5) *(0.993) +(9+normal(0, 5)) P(m-1)\n");
}

TEST_CASE("only what is named gets noise") {
    const Grammar grammar = grammar_of(tree);
    const EditResult edit = randomize(grammar, {.angle = 5, .only = {"R.1.turn"}});
    CHECK(rules(edit.grammar) ==
          "R(m) : m > 0 -> A [-(17+normal(0, 5)) f(64) *(0.8) -(3) R(m-1)] [+(7) f(181) *(0.6) +(23) R(m-1)]\n");
    CHECK(edit.changes == std::vector<std::string>{"noise: R.1.turn_noise 5"});
    CHECK(to_text(randomize(edit.grammar, {.angle = 0, .only = {"R.1.turn"}}).grammar) == to_text(grammar));
    CHECK(rules(randomize(grammar, {.scale = 0.1, .only = {"*.scale"}}).grammar) ==
          "R(m) : m > 0 -> A [-(17) f(64) *(0.8*exp(normal(0, 0.1))) -(3) R(m-1)]"
          " [+(7) f(181) *(0.6*exp(normal(0, 0.1))) +(23) R(m-1)]\n");
    CHECK_THROWS_AS(randomize(grammar, {.angle = 5, .only = {"R.levels"}}), InputError);
    CHECK_THROWS_AS(randomize(grammar, {.angle = 5, .only = {"Q.turn"}}), InputError);
    CHECK_THROWS_AS(randomize(grammar, {.angle = -5}), InputError);
    const Grammar named = grammar_of("define bay = 20\naxiom: Row(3)\nRow(m) : m > 0 -> [A] f(bay) Row(m-1)\n" + leaf);
    CHECK(rules(randomize(named, {.distance = 0.1, .only = {"Row.distance"}}).grammar) ==
          "Row(m) : m > 0 -> [A] f(bay*(1+normal(0, 0.1))) Row(m-1)\n");
}

TEST_CASE("a facade with turned windows does not fall apart") {
    const Grammar grammar = grammar_of(facade);
    const auto before = placed(grammar);
    const auto after = placed(randomize(grammar, {.angle = 5, .seed = 7}).grammar);
    REQUIRE(after.size() == before.size());
    double largest = 0;
    double sum = 0;
    for (const auto& [address, pose] : before) {
        const Similarity& turned = after.at(address);
        CHECK(abs(turned.translation - pose.translation) < 1.5);  // the second pane stands 2 above the place that turns
        largest = std::max(largest, std::abs(heading(turned) - heading(pose)));
        sum += std::abs(heading(turned) - heading(pose));
    }
    CHECK(sum / static_cast<double>(before.size()) > 2);
    CHECK(largest < 25);  // 5 standard deviations
    // A window turns as a whole.
    for (const auto& [address, pose] : after) {
        if (address.back() != 1) continue;
        Address other = address;
        other.back() = 2;
        CHECK(heading(after.at(other)) == Approx(heading(pose)));
    }
}

TEST_CASE("the petals of a ring do not drift: the last stands as near its place as the first") {
    double first = 0;
    double last = 0;
    constexpr int seeds = 60;
    for (unsigned seed = 1; seed <= seeds; ++seed) {
        const Grammar noisy = randomize(grammar_of(ring), {.angle = 5, .seed = seed}).grammar;
        const auto poses = placed(noisy);
        const auto off = [&](int index) {
            double difference = heading(poses.at({1, index})) - 30.0 * (index - 1);
            while (difference > 180) difference -= 360;
            while (difference < -180) difference += 360;
            return difference * difference;
        };
        first += off(1) / seeds;
        last += off(12) / seeds;
    }
    CHECK(std::sqrt(first) == Approx(5).margin(1.6));
    CHECK(std::sqrt(last) == Approx(5).margin(1.6));
}

TEST_CASE("draws stay the same elsewhere when one place is edited") {
    const Grammar noisy = randomize(grammar_of(facade), {.angle = 5, .scale = 0.1, .seed = 3}).grammar;
    const auto before = placed(noisy);
    const auto turn_and_size = [](const Similarity& pose) { return pose.linear; };
    SECTION("another count") {
        const auto after = placed(set(noisy, "Row.count=8"));
        CHECK(after.size() == 4 * 8 * 2);
        for (const auto& [address, pose] : before)
            CHECK(abs(turn_and_size(after.at(address)) - turn_and_size(pose)) < 1e-12);
    }
    SECTION("fewer storeys") {
        for (const auto& [address, pose] : placed(set(noisy, "Wall.count=2"))) CHECK(pose == before.at(address));
    }
    SECTION("another distance") {
        for (const auto& [address, pose] : placed(set(noisy, "Row.distance=25")))
            CHECK(abs(turn_and_size(pose) - turn_and_size(before.at(address))) < 1e-12);
    }
    SECTION("an exception") {
        Grammar excepted = noisy;
        excepted.exceptions.push_back({{1, 2, 3}, {}, {}, {}});
        const auto after = placed(excepted);
        CHECK(after.size() == before.size() - 2);
        for (const auto& [address, pose] : after) CHECK(pose == before.at(address));
    }
    SECTION("another seed") {
        Grammar other = noisy;
        other.seed = 4;
        const auto after = placed(other);
        CHECK(std::ranges::none_of(before, [&](const auto& entry) { return after.at(entry.first) == entry.second; }));
    }
    SECTION("noise of distances beside it") {
        for (const auto& [address, pose] : placed(randomize(noisy, {.distance = 0.1}).grammar))
            CHECK(abs(turn_and_size(pose) - turn_and_size(before.at(address))) < 1e-12);
    }
}

TEST_CASE("randomized random grammars come back exactly") {
    for (unsigned seed = 1; seed <= 40; ++seed) {
        Random random(seed);
        const Grammar grammar = without_noise(random_grammar(random));
        const Grammar noisy = randomize(grammar, {.angle = 5, .distance = 0.1, .scale = 0.2}).grammar;
        INFO(seed);
        CHECK(same_grammar(parse_grammar(to_text(noisy)), noisy));
        CHECK(to_text(without_noise(noisy)) == to_text(grammar));
    }
}

TEST_CASE("symmetrizing takes away noise and exceptions that only move, turn or scale") {
    const Grammar grammar = grammar_of(
        "axiom: Row(6)\nRow(m) : m > 0 -> [A] f(10) Row(m-1)\n"
        "except 1.1 -> f(0.2) +(3) A\nexcept 1.2 -> f(-3) B\nexcept 1.3 ->\nexcept 1.4 -> *(1.01) z(1) A\n"
        "except 1.5 -> -(2) A\n" +
        leaf);
    const EditResult edit = symmetrize(randomize(grammar, {.angle = 4}).grammar);
    REQUIRE(edit.grammar.exceptions.size() == 3);
    CHECK(edit.grammar.exceptions[0].address == Address{1, 2});
    CHECK(edit.grammar.exceptions[0].successor.size() == 2);  // a stand-in keeps its motion
    CHECK(edit.grammar.exceptions[1].address == Address{1, 3});
    CHECK(edit.grammar.exceptions[2].successor.size() == 2);  // z(1) A
    CHECK(rules(edit.grammar) == rules(grammar));
    CHECK(edit.changes == std::vector<std::string>{"noise taken away: Row.A.angle_noise",
                                                   "2 exceptions dropped that only moved, turned or scaled",
                                                   "1 exception moved back to the regular place"});
    CHECK(symmetrize(grammar, {.all_exceptions = true}).grammar.exceptions.empty());
}

TEST_CASE("symmetrizing closes rings that nearly close, and leaves others open") {
    CHECK(rules(symmetrize(grammar_of("axiom: P(12)\nP(m) : m > 0 -> [f(9) A] +(29.6) P(m-1)\n" + leaf)).grammar) ==
          "P(m) : m > 0 -> [f(9) A] +(30) P(m-1)\n");
    CHECK(rules(symmetrize(grammar_of("axiom: P(7)\nP(m) : m > 0 -> [f(9) A] -(51.43) P(m-1)\n" + leaf)).grammar) ==
          "P(m) : m > 0 -> [f(9) A] -(360/7) P(m-1)\n");
    const std::string open = "axiom: P(5)\nP(m) : m > 0 -> [f(9) A] +(60) P(m-1)\n" + leaf;
    CHECK(symmetrize(grammar_of(open)).changes.empty());
}

TEST_CASE("symmetrizing makes neighbouring rules and branches agree where they nearly do") {
    CHECK(rules(symmetrize(grammar_of("axiom: [X(5)] f(40) [Y(5)]\nX(m) : m > 0 -> [A] -(90) f(10.07) +(90) X(m-1)\n"
                                      "Y(m) : m > 0 -> [B] -(90) f(10) +(90.2) Y(m-1)\n" +
                                      leaf))
                    .grammar) ==
          "X(m) : m > 0 -> [A] -(90) f(10) +(90) X(m-1)\nY(m) : m > 0 -> [B] -(90) f(10) +(90) Y(m-1)\n");
    CHECK(rules(symmetrize(
                    grammar_of("axiom: T(3)\nT(m) : m > 0 -> [A] [+(29.7) *(0.7) T(m-1)] [-(30) *(0.71) T(m-1)]\n" + leaf))
                    .grammar) == "T(m) : m > 0 -> [A] [+(30) *(0.7) T(m-1)] [-(30) *(0.7) T(m-1)]\n");
    const std::string different =
        "axiom: [X(5)] [Y(5)]\nX(m) : m > 0 -> [A] f(10) X(m-1)\nY(m) : m > 0 -> [A] f(12) Y(m-1)\n";
    CHECK(symmetrize(grammar_of(different + leaf)).changes.empty());
}

TEST_CASE("uniform noise stays within its limits, is found again and taken away") {
    for (const std::string& body : {facade, ring, tree, helix}) {
        const Grammar grammar = grammar_of(body);
        const RandomizeOptions options{.angle = 5,
                                       .distance = 0.1,
                                       .scale = 0.2,
                                       .angle_distribution = NoiseDistribution::uniform,
                                       .distance_distribution = NoiseDistribution::uniform,
                                       .scale_distribution = NoiseDistribution::uniform};
        const Grammar noisy = parse_grammar(to_text(randomize(grammar, options).grammar));
        CHECK(to_text(noisy).find("normal") == std::string::npos);
        CHECK(noise_in(noisy).angle == Noise{NoiseDistribution::uniform, 5});
        CHECK(to_text(without_noise(noisy)) == to_text(grammar));
        CHECK(to_text(randomize(noisy, {.angle = 5, .distance = 0.1, .scale = 0.2}).grammar) ==
              to_text(randomize(grammar, {.angle = 5, .distance = 0.1, .scale = 0.2}).grammar));
    }
    const Grammar noisy =
        randomize(grammar_of(ring), {.angle = 5, .angle_distribution = NoiseDistribution::uniform}).grammar;
    CHECK(rules(noisy) == "Ring(m) : m > 0 -> [+(uniform(-5, 5)) f(50) A] +(30) Ring(m-1)\n");
    const Grammar less = set(noisy, "Ring.A.angle_noise=2");
    CHECK(rules(less) == "Ring(m) : m > 0 -> [+(uniform(-2, 2)) f(50) A] +(30) Ring(m-1)\n");
    for (const auto& [address, pose] : placed(less)) {
        const double off = heading(pose) / 30 - std::round(heading(pose) / 30);
        CHECK(std::abs(off) * 30 <= 2);
    }
    const Grammar helical =
        randomize(grammar_of(helix), {.angle = 5, .angle_distribution = NoiseDistribution::uniform}).grammar;
    CHECK(rules(set(helical, "P.turn_noise=1")).find("uniform(-1, 1)") != std::string::npos);
}

TEST_CASE("single numbers have noise of their own") {
    const Grammar grammar = grammar_of(helix);
    const RandomizeOptions options{.angle = 5, .named = {{"P.distance", {NoiseDistribution::uniform, 0.3}}, {"P.turn", {}}}};
    const Grammar noisy = randomize(grammar, options).grammar;
    CHECK(rules(noisy) == "P(m) : m > 0 -> A f(27.5*(1+uniform(-0.3, 0.3))) *(0.993) +(8.5) P(m-1)\n");
    CHECK_THROWS_AS(randomize(grammar, {.named = {{"P.count", {}}}}), InputError);
    for (const GrammarNumber& number : grammar_numbers(noisy))
        if (number.name == "P.distance") CHECK(noise_on(noisy, number) == Noise{NoiseDistribution::uniform, 0.3});
}

TEST_CASE("what is nearly regular is a matter of the tolerance") {
    const Grammar bent =
        grammar_of("axiom: Ring(12)\nRing(m) : m > 0 -> [f(50) A] +(28.8) Ring(m-1)\n" + leaf);  // 14.4 open
    CHECK(to_text(symmetrize(bent).grammar) == to_text(bent));
    CHECK(rules(symmetrize(bent, {.tolerance = 2}).grammar) == "Ring(m) : m > 0 -> [f(50) A] +(30) Ring(m-1)\n");
    const Grammar nearly = grammar_of("axiom: Ring(12)\nRing(m) : m > 0 -> [f(50) A] +(29.5) Ring(m-1)\n" + leaf);
    CHECK(to_text(symmetrize(nearly, {.tolerance = 0}).grammar) == to_text(nearly));
    CHECK(to_text(symmetrize(nearly).grammar) != to_text(nearly));
}
