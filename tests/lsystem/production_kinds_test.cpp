// Decompositions and homomorphisms beside productions that take a step.

#include <catch2/catch.hpp>

#include <algorithm>

#include "lsystem/derive.h"
#include "lsystem/grammar_text.h"
#include "lsystem/interpret.h"

using namespace rinceau;

/// The grammar with its productions of one symbol made decompositions or homomorphisms.
static Grammar with_kind(Grammar grammar, const std::string& symbol, ProductionKind kind) {
    for (Production& production : grammar.productions) {
        if (production.symbol == symbol) production.kind = kind;
    }
    return grammar;
}
static Grammar grammar_of(const std::string& body) { return parse_grammar("lsystem 1\n" + body); }
static Grammar decomposing(const std::string& body, const std::string& symbol) {
    return with_kind(grammar_of(body), symbol, ProductionKind::decomposition);
}
static Grammar drawing(const std::string& body, const std::string& symbol) {
    return with_kind(grammar_of(body), symbol, ProductionKind::homomorphism);
}

static std::string derived(const Grammar& grammar, int depth = -1) { return to_text(derive(grammar, {.depth = depth})); }

/// "Window 1.2" of each drawn terminal, in order of derivation.
static std::string drawn(const Grammar& grammar, int depth = -1) {
    std::string text;
    for (const Placement& placement : interpret(grammar, {.derive = {.depth = depth}, .addresses = true})) {
        text += (text.empty() ? "" : ", ") + grammar.terminals[static_cast<std::size_t>(placement.terminal)].symbol + ' ';
        for (std::size_t i = 0; i < placement.address.size(); ++i) {
            text += (i == 0 ? "" : ".") + std::to_string(placement.address[i]);
        }
    }
    return text;
}

TEST_CASE("a decomposition applies at once, to the axiom and to what a step made, and takes no step") {
    const std::string body =
        "axiom: A(1)\n"
        "A(n) -> B(n) [D(3)] A(n+1)\n"
        "D(k) : k > 0 -> d D(k-1)\n"
        "D(k) : k == 0 -> e\n";
    const Grammar grammar = decomposing(body, "D");
    CHECK(derived(grammar, 0) == "A(1)");
    CHECK(derived(grammar, 1) == "B(1) [ d d d e ] A(2)");
    CHECK(derived(grammar, 2) == "B(1) [ d d d e ] B(2) [ d d d e ] A(3)");
    CHECK(derived(decomposing("axiom: D(2)\nD(k) : k > 0 -> d D(k-1)\n", "D"), 0) == "d d D(0)");
}

TEST_CASE("what a decomposition leaves is rewritten in the next step") {
    const Grammar grammar = decomposing("axiom: D\nD -> A A\nA -> D f(1)\n", "D");
    CHECK(derived(grammar, 0) == "A A");
    CHECK(derived(grammar, 1) == "A A f(1) A A f(1)");
}

TEST_CASE("a homomorphism draws and leaves the derived string as it is") {
    const std::string body =
        "axiom: A(2)\n"
        "A(n) : n > 0 -> I [+(45) A(n-1)] A(n-1)\n"
        "I -> Line f(1)\n"
        "terminal Line: path \"M0 0V-1\"\n";
    const Grammar grammar = drawing(body, "I");
    CHECK(derived(grammar) == "I [ +(45) I [ +(45) A(0) ] A(0) ] I [ +(45) A(0) ] A(0)");
    const std::vector<Placement> placements = interpret(grammar);
    REQUIRE(placements.size() == 3);
    CHECK(abs(placements[2].pose.translation - Point{0, 1}) < 1e-12);  // the f of the homomorphism has moved the turtle
}

TEST_CASE("modules of a homomorphism are counted below the module they stand for") {
    const std::string body =
        "axiom: P(2) Q\n"
        "P(m) : m > 0 -> [A] f(13) P(m-1)\n"
        "A -> X [Y] X\n"
        "Y -> Z Z\n"
        "terminal X: path \"M0 0V-1\"\nterminal Z: path \"M0 0V-1\"\nterminal Q: path \"M0 0V-1\"\n";
    const Grammar grammar = with_kind(drawing(body, "A"), "Y", ProductionKind::homomorphism);
    CHECK(derived(grammar) == "[ A ] f(13) [ A ] f(13) P(0) Q");
    CHECK(drawn(grammar) == "X 1.1.1, Z 1.1.2.1, Z 1.1.2.2, X 1.1.3, X 1.2.1, Z 1.2.2.1, Z 1.2.2.2, X 1.2.3, Q 2");
}

TEST_CASE("exceptions apply to what a homomorphism draws and to what it stands for") {
    const std::string body =
        "axiom: P(2)\n"
        "P(m) : m > 0 -> [A] f(13) P(m-1)\n"
        "A -> X X\n"
        "terminal X: path \"M0 0V-1\"\nterminal Q: path \"M0 0V-1\"\n";
    CHECK(drawn(drawing(body + "except 1.1.2 -> Q\n", "A")) == "X 1.1.1, Q 1.1.2, X 1.2.1, X 1.2.2");
    CHECK(drawn(drawing(body + "except 1.2 -> Q\n", "A")) == "X 1.1.1, X 1.1.2, Q 1.2");
    CHECK(drawn(drawing(body + "except 1.2 -> +(3) A\nexcept 1.2.1 ->\n", "A")) == "X 1.1.1, X 1.1.2, X 1.2.2");
}

TEST_CASE("a symbol that stays where the depth is used up is drawn by its homomorphism, with its address") {
    const std::string body =
        "axiom: T\n"
        "T -> S [+(30) T] T\n"
        "terminal S: path \"M0 0V-1\"\nterminal X: path \"M0 0V-1\"\n";
    Grammar grammar = grammar_of(body);
    grammar.productions.push_back({.symbol = "T", .successor = {{.symbol = "X"}}, .kind = ProductionKind::homomorphism});
    CHECK(derived(grammar, 1) == "S [ +(30) T ] T");
    CHECK(drawn(grammar, 0) == "X 1.1");
    CHECK(drawn(grammar, 1) == "S 1.1, X 1.2.1, X 1.3.1");
}

TEST_CASE("productions that take a step do not apply to what a homomorphism makes") {
    const std::string body =
        "axiom: A\n"
        "A -> B\n"
        "C -> A [D(2)]\n"
        "D(n) : n > 0 -> E D(n-1)\n"
        "terminal A: path \"M0 0V-1\"\nterminal B: path \"M0 0V-1\"\nterminal D: path \"M0 0V-1\"\nterminal E: path \"M0 "
        "0V-1\"\n";
    Grammar grammar = grammar_of(body);
    grammar.axiom.push_back({.symbol = "C"});
    const Grammar all = with_kind(with_kind(grammar, "C", ProductionKind::homomorphism), "D", ProductionKind::homomorphism);
    CHECK(derived(all) == "B C");
    CHECK(drawn(all) == "B 1.1, A 2.1, E 2.2.1, E 2.2.2, D 2.2.3");
}

TEST_CASE("decompositions and homomorphisms that do not end are stopped, and the production is named") {
    using Catch::Contains;
    const std::string body = "axiom: A\nA -> f(1) A\nterminal A: path \"M0 0V-1\"\n";
    for (const int depth : {-1, 5}) {
        CHECK_THROWS_WITH(derived(decomposing(body, "A"), depth),
                          Contains("production A at line 3 was applied 100,001 times") &&
                              Contains("the limit is 100,000 decompositions or homomorphisms one inside the other"));
        CHECK_THROWS_WITH(drawn(drawing(body, "A"), depth), Contains("production A at line 3 was applied 100,001 times"));
        CHECK(derived(drawing(body, "A"), depth) == "A");
    }
    CHECK_THROWS_WITH(derived(decomposing("axiom: A\nA -> A A B\nB -> A\n", "A")), Contains("production A at line 3"));
    const Grammar wide = decomposing("axiom: A(60)\nA(n) : n > 0 -> A(n-1) A(n-1)\n", "A");
    CHECK_THROWS_WITH(derived(wide, 0), Contains("the limit is 20,000,000 modules"));
}

TEST_CASE("a homomorphism and a decomposition can draw at random, and keep to their places") {
    const auto widths = [](const std::string& count) {
        const Grammar grammar =
            drawing("axiom: P(" + count + ")\nP(m) : m > 0 -> [A] f(1) P(m-1)\nA -> *(uniform(1, 2)) X\n" +
                        "terminal X: path \"M0 0V-1\"\n",
                    "A");
        std::vector<double> scales;
        for (const Placement& placement : interpret(grammar)) scales.push_back(abs(placement.pose.linear));
        return scales;
    };
    const std::vector<double> few = widths("4");
    std::vector<double> many = widths("9");
    many.resize(4);
    CHECK(few == many);
    std::ranges::sort(many);
    CHECK(std::ranges::adjacent_find(many) == many.end());
}
