// What is drawn in one place of a derivation does not depend on what is written or drawn elsewhere.

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <map>

#include "lsystem/derive.h"
#include "lsystem/grammar_text.h"
#include "lsystem/interpret.h"

using namespace rinceau;

static Grammar grammar_of(const std::string& body) { return parse_grammar("lsystem 1\n" + body); }

static ModuleString derived(const Grammar& grammar, int depth = -1, std::optional<std::uint64_t> seed = {}) {
    return derive(grammar, {.depth = depth, .seed = seed});
}
static std::string text_of(const std::string& body) { return to_text(derived(grammar_of(body))); }

/// The first arguments of the modules of a symbol, in order of derivation.
static std::vector<double> arguments_of(const ModuleString& string, const std::string& symbol) {
    std::vector<double> result;
    for (const Module& module : string.modules) {
        if (string.symbols[static_cast<std::size_t>(module.symbol)] == symbol) result.push_back(module.arguments.at(0));
    }
    return result;
}
static std::vector<double> arguments_of(const std::string& body, const std::string& symbol, int depth = -1) {
    return arguments_of(derived(grammar_of(body), depth), symbol);
}

/// The first symbols of the derived string that are among `wanted`.
static std::string symbols_of(const Grammar& grammar, const std::string& wanted) {
    std::string result;
    const ModuleString string = derived(grammar);
    for (const Module& module : string.modules) {
        const std::string& symbol = string.symbols[static_cast<std::size_t>(module.symbol)];
        if (wanted.find(symbol) != std::string::npos) result += symbol;
    }
    return result;
}

static std::vector<double> front(std::vector<double> values, std::size_t count) {
    values.resize(count);
    return values;
}

static bool all_differ(std::vector<double> values) {
    std::ranges::sort(values);
    return std::ranges::adjacent_find(values) == values.end();
}

/// A row of towers with `count` floors each; every tower leans at random, every window has a random width.
static std::string row(const std::string& count, const std::string& floors = "3") {
    return "axiom: Row(" + count +
           ")\n"
           "Row(m) : m > 0 -> [+(normal(0, 3)) Tower(" +
           floors +
           ")] f(uniform(10, 20)) Row(m-1)\n"
           "Tower(m) : m > 0 -> Window(uniform(1, 2)) f(normal(5, 1)) Tower(m-1)\n";
}

TEST_CASE("every place draws its own number, and the same one every time") {
    const ModuleString once = derived(grammar_of(row("20"))), again = derived(grammar_of(row("20")));
    CHECK(to_text(once) == to_text(again));
    for (const std::string symbol : {"+", "Window", "f"}) CHECK(all_differ(arguments_of(once, symbol)));
}

TEST_CASE("a seed of the options comes before the grammar's own, and that before 1") {
    Grammar grammar = grammar_of(row("5"));
    const std::string one = to_text(derived(grammar));
    CHECK(to_text(derived(grammar, -1, 1)) == one);
    grammar.seed = 7;
    const std::string seven = to_text(derived(grammar));
    CHECK(seven != one);
    CHECK(to_text(derived(grammar, -1, 1)) == one);
    grammar.seed.reset();
    CHECK(to_text(derived(grammar, -1, 7)) == seven);
}

TEST_CASE("a larger count leaves the draws of the first elements as they were") {
    const ModuleString few = derived(grammar_of(row("5"))), many = derived(grammar_of(row("30")));
    for (const std::string symbol : {"+", "Window", "f"}) {
        const std::vector<double> before = arguments_of(few, symbol);
        CHECK(before == front(arguments_of(many, symbol), before.size()));
    }
    const std::vector<double> low = arguments_of(row("5", "2"), "Window"), high = arguments_of(row("5", "6"), "Window");
    for (std::size_t tower = 0; tower < 5; ++tower) {
        for (std::size_t floor = 0; floor < 2; ++floor) CHECK(low[2 * tower + floor] == high[6 * tower + floor]);
    }
}

TEST_CASE("commands that are inserted or changed in a successor leave its draws as they were") {
    const std::string start = "axiom: P(4)\nP(m) : m > 0 -> ", end = " P(m-1)\n";
    const std::string before = "[+(normal(20, 3)) f(uniform(5, 9)) A(uniform(0, 1))] f(uniform(30, 40))";
    for (const std::string after : {
             "z(1) [f(3) +(1) +(normal(20, 3)) *(0.5) f(uniform(5, 9)) | A(uniform(0, 1))] f(2) f(uniform(30, 40))",
             "[[+(normal(20, 3)) f(uniform(5, 9)) A(uniform(0, 1))] +(1)] fill(1, 2, 3) -(3) f(uniform(30, 40))",
             "f(uniform(30, 40)) [+(normal(20, 3)) *(normal(1, 0)) f(uniform(5, 9)) A(uniform(0, 1))]",
         }) {
        CHECK(arguments_of(start + before + end, "A") == arguments_of(start + after + end, "A"));
    }
    const std::string after =
        "z(1) [+(1) -(2) +(normal(20, 3)) *(0.5) f(3) f(uniform(5, 9)) | A(uniform(0, 1))] f(3) f(uniform(30, 40))";
    const std::vector<double> turns = arguments_of(start + after + end, "+"), moves = arguments_of(start + after + end, "f");
    const std::vector<double> turns_before = arguments_of(start + before + end, "+"),
                              moves_before = arguments_of(start + before + end, "f");
    for (std::size_t i = 0; i < 4; ++i) {
        CHECK(turns[2 * i + 1] == turns_before[i]);
        CHECK(moves[4 * i + 1] == moves_before[2 * i]);
        CHECK(moves[4 * i + 3] == moves_before[2 * i + 1]);
    }
}

TEST_CASE("a draw that is added or removed elsewhere leaves the others as they were") {
    const std::string calm =
        "axiom: Row(6)\n"
        "Row(m) : m > 0 -> [+(normal(0, 3)) Tower(3)] f(15) Row(m-1)\n"
        "Tower(m) : m > 0 -> Window(uniform(1, 2)) f(5) Tower(m-1)\n";
    CHECK(arguments_of(calm, "+") == arguments_of(row("6"), "+"));
    CHECK(arguments_of(calm, "Window") == arguments_of(row("6"), "Window"));
    // another argument of the same module, another deviation, a condition and a constant that draw
    const std::string other =
        "define height = normal(5, 1)\n"
        "axiom: Row(6)\n"
        "Row(m) : m > 0 && uniform(0, 1) >= 0 -> [+(normal(0, 6)) Tower(3)] f(height) Row(m-1)\n"
        "Tower(m) : m > 0 -> Window(uniform(1, 2), normal(3, 1)) f(height) Tower(m-1)\n";
    const std::vector<double> turns = arguments_of(calm, "+"), wider = arguments_of(other, "+");
    for (std::size_t i = 0; i < turns.size(); ++i) CHECK(wider[i] == 2 * turns[i]);
    CHECK(arguments_of(other, "Window") == arguments_of(calm, "Window"));
    const std::vector<double> heights = arguments_of(other, "f");
    CHECK(heights.front() != 5);
    CHECK(std::ranges::count(heights, heights.front()) == static_cast<std::ptrdiff_t>(heights.size()));
}

TEST_CASE("an exception changes no draw elsewhere, and a single symbol in it draws as the one it replaces") {
    const std::string plain = row("4");
    const std::vector<double> windows = arguments_of(plain, "Window");
    const auto changed = [&](const std::string& exception) { return arguments_of(plain + exception, "Window"); };
    std::vector<double> expected = windows;
    expected.erase(expected.begin() + 3, expected.begin() + 6);
    CHECK(changed("except 1.2 ->\n") == expected);
    CHECK(changed("except 1.2 -> +(uniform(1, 2)) Tower(3)\n") == windows);
    CHECK(changed("except 1.2 -> Other(normal(0, 1))\n") == expected);
    const std::vector<double> longer = changed("except 1.2 -> Tower(5)\n");
    CHECK(front(longer, 6) == front(windows, 6));
    CHECK(std::vector(longer.begin() + 8, longer.end()) == std::vector(windows.begin() + 6, windows.end()));
    expected = windows;
    expected[4] = 9;
    CHECK(changed("except 1.2.2 -> Window(9)\n") == expected);
    CHECK(changed("except 1.2.2 -> +(normal(0, 1)) Window(9) Other\n") == expected);
}

TEST_CASE("what is drawn at a small depth is what is drawn at a large one") {
    const std::string body =
        "axiom: Tree(uniform(8, 9))\n"
        "Tree(l) -> Branch(l) [+(normal(20, 5)) Tree(l*uniform(0.6, 0.8))] [-(normal(20, 5)) Tree(l*uniform(0.6, 0.8))]\n";
    std::vector<double> known = arguments_of(body, "Branch", 1);
    CHECK(known.size() == 1);
    for (int depth = 2; depth < 7; ++depth) {
        const std::vector<double> branches = arguments_of(body, "Branch", depth);
        const std::vector<double> ends = arguments_of(body, "Tree", depth - 1);
        // each branch is one of before or has grown out of an end of before
        for (const double length : known) CHECK(std::ranges::count(branches, length) == 1);
        for (const double length : ends) CHECK(std::ranges::count(branches, length) == 1);
        CHECK(branches.size() == known.size() + ends.size());
        known = branches;
    }
}

TEST_CASE("drawn numbers have the mean and the deviation asked for") {
    const std::vector<double> normal = arguments_of("axiom: P(20000)\nP(m) : m > 0 -> A(normal(20, 3)) P(m-1)\n", "A");
    const std::vector<double> uniform = arguments_of("axiom: P(20000)\nP(m) : m > 0 -> A(uniform(-1, 3)) P(m-1)\n", "A");
    const auto mean = [](const std::vector<double>& values) {
        double sum = 0;
        for (const double value : values) sum += value;
        return sum / static_cast<double>(values.size());
    };
    const auto deviation = [&](const std::vector<double>& values) {
        double sum = 0;
        for (const double value : values) sum += std::pow(value - mean(values), 2);
        return std::sqrt(sum / static_cast<double>(values.size()));
    };
    const double root = std::sqrt(20000.0);
    CHECK(std::abs(mean(normal) - 20) < 4 * 3 / root);
    CHECK(std::abs(deviation(normal) - 3) < 4 * 3 / root);
    CHECK(std::abs(mean(uniform) - 1) < 4 * 1.16 / root);
    CHECK(*std::ranges::min_element(uniform) >= -1);
    CHECK(*std::ranges::max_element(uniform) < 3);
}

/// The grammar with weights for its last productions.
static Grammar weighted(const std::string& body, const std::vector<std::string>& weights) {
    Grammar grammar = grammar_of(body);
    for (std::size_t i = 0; i < weights.size(); ++i) {
        grammar.productions[grammar.productions.size() - weights.size() + i].weight = parse_expression(weights[i]);
    }
    return grammar;
}

static std::string choices(const std::vector<std::string>& weights, const std::string& count = "6000") {
    const std::string body = "axiom: P(" + count + ")\nP(m) : m > 0 -> C P(m-1)\nC -> X\nC -> Y\nC -> Z\n";
    return symbols_of(weighted(body, weights), "XYZ");
}

TEST_CASE("productions are chosen in proportion to their weights") {
    const std::string chosen = choices({"1", "2", "5"});
    const double count = static_cast<double>(chosen.size());
    CHECK(chosen.size() == 6000);
    const std::map<char, double> share{{'X', 1.0 / 8}, {'Y', 2.0 / 8}, {'Z', 5.0 / 8}};
    double chi = 0;
    for (const auto& [symbol, p] : share) {
        const double difference = static_cast<double>(std::ranges::count(chosen, symbol)) - p * count;
        chi += difference * difference / (p * count);
    }
    CHECK(chi < 18.4);  // of 2 degrees of freedom but for 1 in 10,000
    CHECK(choices({"10", "20", "50"}) == chosen);
    CHECK(choices({"0", "0", "0.001"}, "50") == std::string(50, 'Z'));
}

TEST_CASE("a change of one weight changes no choice between two others") {
    const std::string before = choices({"1", "2", "5"}), after = choices({"1", "2", "9"}),
                      without = choices({"1", "2", "0"});
    int changed = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
        if (before[i] != after[i]) {
            CHECK(after[i] == 'Z');
            ++changed;
        }
        if (before[i] != 'Z') CHECK(without[i] == before[i]);
    }
    CHECK(changed > 100);
}

TEST_CASE("the choice is made among productions that fit and hold, if the first of them has a weight") {
    Grammar grammar = grammar_of(
        "axiom: C(1) C(2) C(3) C\n"
        "C(n) : n > 2 -> First\n"
        "C(n) : n == 1 -> Never\n"
        "C(n) : n > 0 -> Second\n"
        "C(n) -> Third\n"
        "C -> Fourth\n");
    grammar.productions[1].weight = parse_expression("0");
    grammar.productions[2].weight = parse_expression("n - 1");
    grammar.productions[3].weight = parse_expression("if(n == 1, 1, 0)");
    CHECK(to_text(derived(grammar)) == "Third Second First Fourth");
}

TEST_CASE("choices keep to their places as draws do") {
    const auto chosen = [](const std::string& count, const std::string& rest) {
        return symbols_of(
            weighted("axiom: P(" + count + ")\nP(m) : m > 0 -> [+(uniform(0, 1)) C] " + rest + " P(m-1)\nC -> X\nC -> Y\n",
                     {"1", "1"}),
            "XY");
    };
    CHECK(chosen("20", "") == chosen("50", "").substr(0, 20));
    CHECK(chosen("20", "") == chosen("20", "z(1) f(normal(2, 1))"));
    CHECK(chosen("200", "").find("XXXXXX") != std::string::npos);
    std::string replaced = chosen("20", "");
    replaced.erase(6, 1);
    Grammar grammar = weighted(
        "axiom: P(20)\nP(m) : m > 0 -> [+(uniform(0, 1)) C]  P(m-1)\nC -> X\nC -> Y\nexcept 1.7 -> D\n", {"1", "1"});
    CHECK(symbols_of(grammar, "XY") == replaced);
}

static std::string fault_of(const Grammar& grammar) {
    try {
        derive(grammar);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST_CASE("weights and deviations that mean nothing are reported where they stand") {
    using Catch::Contains;
    const std::string body = "axiom: C(0)\nC(n) -> X\nC(n) -> Y\n";
    CHECK_THAT(fault_of(weighted(body, {"1", "-2"})),
               Contains("4:1: expected a weight of C that is finite and not below 0, found -2"));
    CHECK_THAT(fault_of(weighted(body, {"1", "1/n"})), Contains("4:1: ") && Contains("found 0/0 or an overflow"));
    CHECK_THAT(fault_of(weighted(body, {"0", "n"})), Contains("3:1: expected a weight above 0 among the productions of C"));
    CHECK_THAT(fault_of(grammar_of("axiom: A f(normal(1, -3))\n")),
               Contains("2:10: expected a deviation that is not below 0 in normal(mean, deviation), found -3"));
    CHECK_THAT(fault_of(grammar_of("axiom: A(2)\nA(n) : max(1, normal(0, n - 3)) > 0 -> B\n")),
               Contains("3:1: ") && Contains("found -1"));
    CHECK_THAT(fault_of(grammar_of("axiom: f(uniform(0, 1/0))\n")), Contains("2:8: expected finite arguments of f"));
    CHECK_THAT(fault_of(grammar_of("define a = normal(1, -1)\naxiom: A(a)\n")), Contains("2:") && Contains("found -1"));
}

TEST_CASE("a constant draws once, by its name") {
    const std::string two = text_of("define a = uniform(0, 1)\ndefine b = uniform(0, 1)\naxiom: A(a) A(a) B(b)\n");
    const std::string turned = text_of("define b = uniform(0, 1)\ndefine a = uniform(0, 1)\naxiom: A(a) A(a) B(b)\n");
    CHECK(two == turned);
    const std::vector<double> values =
        arguments_of("define a = uniform(0, 1)\ndefine b = uniform(0, 1)\naxiom: A(a) A(a) A(b)\n", "A");
    CHECK(values[0] == values[1]);
    CHECK(values[0] != values[2]);
}

TEST_CASE("a derivation that draws is the same with and without addresses") {
    const Grammar grammar = grammar_of(row("8") + "terminal Window: path \"M0 0L1 1\"\n");
    const std::vector<Placement> plain = interpret(grammar),
                                 tracked = interpret(grammar, {.addresses = true, .trails = true});
    REQUIRE(plain.size() == 24);
    REQUIRE(tracked.size() == 24);
    for (std::size_t i = 0; i < plain.size(); ++i) CHECK(plain[i].pose == tracked[i].pose);
}
