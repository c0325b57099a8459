#include <catch2/catch.hpp>

#include <cmath>
#include <string>
#include <vector>

#include "analyzer/module_writer.h"
#include "analyzer/redrawn.h"
#include "analyzer/rule_sets.h"
#include "lsystem/interpret.h"

using namespace rinceau;
using namespace rinceau::test;

namespace {

/// Where the turtle stands after these modules.
Similarity turtle_after(const std::vector<ModuleTemplate>& modules) {
    Grammar grammar;
    grammar.terminals.push_back({.symbol = "A"});
    grammar.axiom = modules;
    grammar.axiom.push_back(command("A"));
    return interpret(grammar).front().pose;
}

std::vector<ModuleTemplate> written(const Similarity& move, const MoveSlack& slack) {
    std::vector<ModuleTemplate> modules;
    append_move(modules, move, slack);
    return modules;
}

std::string text(const std::vector<ModuleTemplate>& modules) {
    std::string all;
    for (const ModuleTemplate& module : modules) {
        all += (all.empty() ? "" : " ") + module.symbol;
        if (!module.arguments.empty()) all += "(" + to_text(module.arguments[0]) + ")";
    }
    return all;
}

}  // namespace

TEST_CASE("a tidy number is near enough and no number with fewer digits is") {
    Random random(1);
    for (int trial = 0; trial < 500; ++trial) {
        const double value = random.uniform(-1, 1) * std::pow(10, random.uniform(-4, 5));
        const double slack = std::abs(value) * std::pow(10, random.uniform(-8, -0.5));
        const double tidied = tidy(value, slack);
        REQUIRE(std::abs(tidied - value) <= slack);
        // One digit less, from the magnitude of the number down to where it is still different.
        const double magnitude = std::floor(std::log10(std::abs(tidied)));
        int digits = 1;
        const auto rounded_to = [&](double number, int count) {
            const double unit = std::pow(10, magnitude - count + 1);
            return std::round(number / unit) * unit;
        };
        while (digits < 16 && std::abs(rounded_to(tidied, digits) - tidied) > 1e-12 * std::abs(tidied)) ++digits;
        if (digits > 1) CHECK(std::abs(rounded_to(value, digits - 1) - value) > slack * (1 - 1e-9));
    }
    CHECK(tidy(89.9998, 1e-3) == 90);
    CHECK(tidy(1e-5, 1e-4) == 0);
    CHECK(tidy(1.0 / 3, 0) == 1.0 / 3);
}

TEST_CASE("the turtle's commands make the move that they were written for, within the slack") {
    Random random(2);
    for (int trial = 0; trial < 1000; ++trial) {
        const Similarity move = random_similarity(random);
        const double reach = abs(move.translation);
        MoveSlack slack;
        slack.length = std::pow(10, random.uniform(-6, 0));
        slack.turn = slack.length / reach;
        slack.spin = std::pow(10, random.uniform(-6, -1));
        slack.scale = std::pow(10, random.uniform(-6, -1));
        const Similarity made = turtle_after(written(move, slack));
        INFO(text(written(move, slack)));
        CHECK(made.mirrored == move.mirrored);
        CHECK(abs(made.translation - move.translation) <= 2.5 * slack.length);
        CHECK(std::abs(scale_of(made) / scale_of(move) - 1) <= 1.01 * slack.scale);
        CHECK(std::abs(wrap_angle(arg(made.linear) - arg(move.linear))) <= 1.01 * (slack.spin + slack.turn));
    }
}

TEST_CASE("without slack a move is exact") {
    Random random(3);
    for (int trial = 0; trial < 200; ++trial) {
        const Similarity move = random_similarity(random);
        CHECK(distance(turtle_after(written(move, {})), move) < 1e-11 * abs(move.translation));
    }
}

TEST_CASE("what changes nothing is left out, and plain moves read plainly") {
    const MoveSlack slack{1e-3, 1e-4, 1e-4, 1e-4};
    CHECK(written({}, slack).empty());
    CHECK(written({{1, 1e-5}, {1e-4, 1e-4}, false}, slack).empty());
    CHECK(text(written(translate({0, 12.00001}), slack)) == "f(12)");
    CHECK(text(written(translate({0, -5}), slack)) == "f(-5)");
    CHECK(text(written(rotate(radians(30.00001)), slack)) == "+(30)");
    CHECK(text(written(rotate(radians(-45)), slack)) == "-(45)");
    CHECK(text(written(scale_by(2) * mirror_about_heading(), slack)) == "*(2) |");
    CHECK(text(written(rotate(radians(7)) * translate({0, 50}) * rotate(radians(7)), slack)) == "+(7) f(50) +(7)");
}

TEST_CASE("brackets keep the turtle where it was") {
    std::vector<ModuleTemplate> modules = written(translate({3, 4}), {});
    modules.push_back(command("A"));
    CHECK(turtle_after(bracketed(modules)).translation == turtle_after(written(translate({3, 4}), {})).translation);
    Grammar grammar;
    grammar.terminals.push_back({.symbol = "A"});
    grammar.axiom = bracketed(modules);
    grammar.axiom.push_back(command("A"));
    CHECK(interpret(grammar).back().pose == Similarity{});
}
