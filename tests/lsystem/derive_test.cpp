#include "lsystem/derive.h"

#include <catch2/catch.hpp>

#include "lsystem/grammar_text.h"
#include "lsystem/interpret.h"
#include "scene/input_error.h"

using namespace rinceau;

static Grammar grammar_of(const std::string& body) { return parse_grammar("lsystem 1\n" + body); }

static std::string derived(const std::string& body, int depth = -1) {
    DeriveOptions options;
    options.depth = depth;
    return to_text(derive(grammar_of(body), options));
}

/// Addresses of what is drawn, in order of derivation.
static std::vector<std::string> addresses(const std::string& body, int depth = -1) {
    InterpretOptions options{.addresses = true};
    options.derive.depth = depth;
    std::vector<std::string> result;
    for (const Placement& placement : interpret(grammar_of(body), options)) {
        std::string text;
        for (const int number : placement.address) text += (text.empty() ? "" : ".") + std::to_string(number);
        result.push_back(text);
    }
    return result;
}

using Texts = std::vector<std::string>;

TEST_CASE("the first production whose condition holds is applied, else the module stays") {
    const std::string body =
        "axiom: P(2)\n"
        "P(m) : m > 1 -> A P(m-1)\n"
        "P(m) : m > 0 -> B P(m-1)\n";
    CHECK(derived(body) == "A B P(0)");
    CHECK(derived("axiom: X(1, 2) +(3)") == "X(1, 2) +(3)");
    CHECK(derived("axiom: A B\nA ->\n") == "B");
}

TEST_CASE("a depth stops the rewriting there") {
    const std::string koch = "axiom: F\nF -> F +(60) F\n";
    CHECK(derived(koch, 0) == "F");
    CHECK(derived(koch, 1) == "F +(60) F");
    CHECK(derived(koch, 2) == "F +(60) F +(60) F +(60) F");
    CHECK(derived("axiom: A\nA -> B\nB -> C\n", 1) == "B");
}

TEST_CASE("constants are seen in every expression, parameters hide them") {
    CHECK(derived("define n = 2\ndefine k = n*3\naxiom: A(k) P(7)\nP(n) -> B(n, k)") == "A(6) B(7, 6)");
}

TEST_CASE("a symbol can be a terminal and have a production: the production comes first") {
    CHECK(addresses("axiom: A(2)\nA(m) : m > 0 -> [+(30) A(m-1)] A(m-1)\nterminal A: path \"M0 0L1 1\"\n") ==
          Texts{"1.1", "1.2", "1.3", "1.4"});
}

TEST_CASE("addresses count below what was expanded, and recursion goes on counting") {
    const std::string body =
        "axiom: A P(3)\n"
        "P(m) : m > 0 -> [A] f(13) [Q] P(m-1)\n"
        "Q -> A A\n"
        "terminal A: path \"M0 0L1 1\"\n";
    CHECK(addresses(body) == Texts{"1", "2.1", "2.2.1", "2.2.2", "2.3", "2.4.1", "2.4.2", "2.5", "2.6.1", "2.6.2"});
}

TEST_CASE("addresses stay when a count grows") {
    const std::string row = "P(m) : m > 0 -> [A] f(1) P(m-1)\nterminal A: path \"M0 0L1 1\"\n";
    const Texts few = addresses("axiom: P(3)\n" + row);
    const Texts many = addresses("axiom: P(9)\n" + row);
    CHECK(Texts(many.begin(), many.begin() + 3) == few);
}

TEST_CASE("an exception takes the place of the module at its address, only there") {
    const std::string body =
        "axiom: P(3)\n"
        "P(m) : m > 0 -> A P(m-1)\n"
        "terminal A: path \"M0 0L1 1\"\nterminal B: path \"M0 0L1 1\"\n";
    CHECK(derived(body + "except 1.2 -> f(2) B\n") == "A f(2) B A P(0)");
    CHECK(derived(body + "except 1.2 ->\n") == "A A P(0)");
    CHECK(derived(body + "except 1.2 -> A A\n") == "A A A A P(0)");
    CHECK(derived(body + "except 1.9 -> B\nexcept 7 -> B\nexcept 1.2.1 -> B\n") == derived(body));
    CHECK(derived(body + "except 1 -> P(1) B\n") == "A P(0) B");
}

TEST_CASE("what replaces one module has its address, so that deeper exceptions still find their place") {
    const std::string body =
        "axiom: Q\n"
        "Q -> P(2) P(2)\n"
        "P(m) : m > 0 -> A P(m-1)\n"
        "terminal A: path \"M0 0L1 1\"\nterminal B: path \"M0 0L1 1\"\n";
    CHECK(derived(body + "except 1.2 -> +(5) P(3)\nexcept 1.2.3 -> B\n") == "A A P(0) +(5) A A B P(0)");
    CHECK(addresses(body + "except 1.2 -> +(5) P(1)\n") == Texts{"1.1.1", "1.1.2", "1.2.1"});
    // several modules are counted below
    CHECK(addresses(body + "except 1.2 -> A P(1)\n") == Texts{"1.1.1", "1.1.2", "1.2.1", "1.2.2.1"});
    // an exception does not apply within itself
    CHECK(derived(body + "except 1.2 -> P(1)\n") == "A A P(0) A P(0)");
}

TEST_CASE("addresses of all that is drawn differ, whatever the grammar") {
    const std::string body =
        "axiom: T(6) T(2)\n"
        "T(m) : m > 3 -> [+(10) T(m-1)] A [U(m)] T(m-2)\n"
        "T(m) : m == 2 -> [A] U(m-1)\n"
        "U(m) : m > 0 -> A T(m-1) U(m-2)\n"
        "terminal A: path \"M0 0L1 1\"\nterminal T: path \"M0 0L1 1\"\nterminal U: path \"M0 0L1 1\"\n"
        "except 1.3 -> A A T(4)\n";
    Texts all = addresses(body);
    CHECK(all.size() > 20);
    std::sort(all.begin(), all.end());
    CHECK(std::adjacent_find(all.begin(), all.end()) == all.end());
}

static std::string limit_message(const std::string& body, DeriveOptions options = {}) {
    try {
        derive(grammar_of(body), options);
    } catch (const LimitError& error) {
        return error.what();
    }
    return "none";
}

TEST_CASE("what does not end is stopped, and the production is named") {
    CHECK(limit_message("axiom: A\nA -> A\n").find("production A at line 3 was applied 100,001 times") != std::string::npos);
    CHECK(limit_message("axiom: A\nA -> A A\n").find("production A at line 3") != std::string::npos);
    CHECK(limit_message("axiom: A\nA -> B\nB -> A f(1) A\n").find("at line ") != std::string::npos);
    CHECK(limit_message("axiom: P(0.5)\nP(m) : m != 0 -> A P(m-1)\n").find("production P at line 3") != std::string::npos);
    DeriveOptions small;
    small.max_modules = 1000;
    CHECK(limit_message("axiom: P(60)\nP(m) : m > 0 -> P(m-1) P(m-1)\n", small).find("limit is 1,000 modules") !=
          std::string::npos);
    CHECK(limit_message("axiom: P(60)\nP(m) : m > 0 -> P(m-1) P(m-1)\nP(m) ->\n", small).find("production P at line 3") !=
          std::string::npos);
    CHECK(limit_message("axiom: P(60)\nP(m) : m > 0 -> P(m-1) P(m-1)\nP(m) ->\n", small).find("limit is 1,000 modules") !=
          std::string::npos);
    DeriveOptions brief;
    brief.max_seconds = 0.05;
    CHECK(limit_message("axiom: P(60)\nP(m) : m > 0 -> P(m-1) P(m-1)\nP(m) ->\n", brief).find("time limit") !=
          std::string::npos);
}

TEST_CASE("a recursion of 100,000 steps is no trouble") {
    const ModuleString string = derive(grammar_of("axiom: P(99999)\nP(m) : m > 0 -> [A] P(m-1) B\n"));
    CHECK(string.modules.size() == 4 * 99'999 + 1);
}

static std::string input_fault(const std::string& body) {
    try {
        derive(grammar_of(body));
    } catch (const InputError& error) {
        return std::to_string(error.place().line) + ':' + std::to_string(error.place().column);
    }
    return "none";
}

TEST_CASE("values that are no numbers, unknown names and wrong counts of arguments are reported in their place") {
    CHECK(input_fault("axiom: P(1)\nP(m) -> f(1) f(1/(m-1))\n") == "3:14");
    CHECK(input_fault("axiom: f(1/0)") == "2:8");
    CHECK(input_fault("axiom: A(sqrt(-1))") == "2:8");
    CHECK(input_fault("axiom: P(0)\nP(m) : m/m > 1 || m/m -> A\n") == "3:1");
    CHECK(input_fault("axiom: f(width)") == "2:8");
    CHECK(input_fault("axiom: A +(1, 2)") == "2:10");
    CHECK(input_fault("axiom: A P\nP(m) -> A\n") == "2:10");
    CHECK(input_fault("define a = b\naxiom: A") == "2:8");
}

TEST_CASE("progress rises and may cancel") {
    const Grammar grammar = grammar_of("axiom: P(17)\nP(m) : m > 0 -> P(m-1) P(m-1)\n");
    double last = 0;
    int calls = 0;
    derive(grammar, {}, [&](std::string_view, double fraction) {
        CHECK(fraction >= last);
        CHECK(fraction <= 1);
        last = fraction;
        ++calls;
    });
    CHECK(calls > 0);
    struct Cancelled {};
    CHECK_THROWS_AS(derive(grammar, {}, [](std::string_view, double) { throw Cancelled{}; }), Cancelled);
}

TEST_CASE("the text that is passed on piece by piece is that of the derived string") {
    DeriveOptions options;
    options.max_modules = 1'000'000;
    for (const std::string body : {"axiom: A(1, -0.5) [ B ] +(30) ;(2)\nB ->\n", "axiom:\n", "axiom: A\nA ->\n",
                                   "axiom: F(9)\nF(n) : n > 0 -> F(n-1) +(n/7) [ F(n-1) ] | F(n-1)\n"}) {
        const Grammar grammar = grammar_of(body);
        std::string text;
        std::size_t pieces = 0;
        derive_text(grammar, options, [&](std::string_view piece) {
            text += piece;
            ++pieces;
        });
        CHECK(text == to_text(derive(grammar, options)));
        constexpr std::size_t smallest_piece = 1 << 15;
        CHECK(pieces <= text.size() / smallest_piece + 1);
    }
}
