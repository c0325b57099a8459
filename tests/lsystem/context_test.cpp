// Productions with contexts. Facts from Prusinkiewicz, Lindenmayer, The Algorithmic Beauty of Plants, 1990,
// sections 1.8, 1.10.

#include <catch2/catch.hpp>

#include "lsystem/derive.h"
#include "lsystem/grammar_text.h"
#include "lsystem/interpret.h"
#include "scene/input_error.h"

using namespace rinceau;

namespace {

Grammar grammar_of(const std::string& body) { return parse_grammar("lsystem 1\n" + body); }

std::string derived(const std::string& body, int depth = -1) {
    DeriveOptions options;
    options.depth = depth;
    return to_text(derive(grammar_of(body), options));
}

std::string message_of(const std::string& body, const DeriveOptions& options = {}) {
    try {
        derive(grammar_of(body), options);
    } catch (const std::exception& error) {
        return error.what();
    }
    return "nothing was wrong";
}

/// The grammar with a context that never stands anywhere, so that it is derived step by step.
Grammar in_steps(const std::string& body) { return grammar_of(body + "Nowhere < Nothing -> Nothing\n"); }

bool same_placement(const Placement& a, const Placement& b) {
    return a.terminal == b.terminal && a.style == b.style && a.layer == b.layer && a.repaint == b.repaint &&
           a.pose == b.pose && a.address == b.address && a.trail == b.trail && a.production == b.production &&
           a.order == b.order;
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("a signal goes through a string, one symbol a step") {
    const std::string body = "axiom: b a a a\nb < a -> b\nb -> a\n";
    CHECK(derived(body, 1) == "a b a a");
    CHECK(derived(body, 2) == "a a b a");
    CHECK(derived(body, 3) == "a a a b");
    CHECK(derived(body) == "a a a a");
}

TEST_CASE("a signal of the left goes from the root into all branches") {
    const std::string body = "axiom: J [+(30) I] I [-(30) I] I [+(30) I] I\nJ < I -> J\n";
    CHECK(derived(body, 1) == "J [ +(30) J ] J [ -(30) I ] I [ +(30) I ] I");
    CHECK(derived(body, 2) == "J [ +(30) J ] J [ -(30) J ] J [ +(30) I ] I");
    CHECK(derived(body) == "J [ +(30) J ] J [ -(30) J ] J [ +(30) J ] J");
}

TEST_CASE("a signal of the right comes down from the tip and passes branches by") {
    const std::string body = "axiom: I [+(30) I] I [-(30) I] I [+(30) I] J\nI > J -> J\n";
    CHECK(derived(body, 1) == "I [ +(30) I ] I [ -(30) I ] J [ +(30) I ] J");
    CHECK(derived(body) == "J [ +(30) I ] J [ -(30) I ] J [ +(30) I ] J");
}

TEST_CASE("contexts of several symbols look past commands, closed branches and ignored symbols") {
    const std::string string = "A B C [ D E ] [ S G [ H I [ J K ] L ] M N O ]\n";
    CHECK(derived("axiom: " + string + "B C < S > G M -> X\n", 1) == "A B C [ D E ] [ X G [ H I [ J K ] L ] M N O ]");
    CHECK(derived("axiom: " + string + "A C < S -> X\n", 1) == "A B C [ D E ] [ S G [ H I [ J K ] L ] M N O ]");
    CHECK(derived("axiom: " + string + "ignore B G H\nA C < S > M N -> X\n", 1) ==
          "A B C [ D E ] [ X G [ H I [ J K ] L ] M N O ]");
    CHECK(derived("axiom: B f(3) *(2) S z(1) ;(0) G\nB < S > G -> X\n", 1) == "B f(3) *(2) X z(1) ;(0) G");
    // the end of a branch is the end of what stands to the right
    CHECK(derived("axiom: [ S ] G\nS > G -> X\n", 1) == "[ S ] G");
}

TEST_CASE("all symbols of a step see the string before it, with its numbers") {
    // heat between two ends that keep theirs
    const std::string body = "axiom: C(9) C(0) C(0) C(9)\nC(l) < C(x) > C(r) -> C((l+x+r)/3)\n";
    CHECK(derived(body, 1) == "C(9) C(3) C(3) C(9)");
    CHECK(derived(body, 2) == "C(9) C(5) C(5) C(9)");
    const std::string order =
        "axiom: L(1, 2) X(3) R(4) Q(5)\nL(a, b) < X(x) > R(c) Q(d) : x == 3 && d == 5 -> Y(a, b, x, c, d)\n";
    CHECK(derived(order) == "L(1, 2) Y(1, 2, 3, 4, 5) R(4) Q(5)");
    CHECK(derived("axiom: P(1) Q(2) S\nP(a) Q(b) < S -> T(a, b)\n") == "P(1) Q(2) T(1, 2)");
}

TEST_CASE("cells divide or rest by what their neighbours are") {
    // A and B are vegetative cells with a polarity; the cell between two equal ones becomes H and stays
    const std::string body =
        "axiom: A\n"
        "A < B > A -> H\n"
        "A > H -> A\n"
        "A -> A B A\n";
    CHECK(derived(body, 1) == "A B A");
    CHECK(derived(body, 2) == "A B A H A B A");
    CHECK(derived(body, 3) == "A B A H A H A B A H A B A");
}

TEST_CASE("the first production that fits applies, with a context or without") {
    CHECK(derived("axiom: A B\nA < B -> C\nB -> D\n", 1) == "A C");
    CHECK(derived("axiom: A B\nB -> D\nA < B -> C\n", 1) == "A D");
    CHECK(derived("axiom: X B\nA < B -> C\nB -> D\n", 1) == "X D");
    CHECK(derived("axiom: A(2) B\nA(n) < B : n > 2 -> C\nA(n) < B : n > 1 -> D(n)\n", 1) == "A(2) D(2)");
}

TEST_CASE("a derivation with contexts ends when no production has applied in a step") {
    // the last symbol waits three steps for its neighbour
    CHECK(derived("axiom: W(3) S\nW(n) : n > 0 -> W(n-1)\nW(n) < S : n == 0 -> T\n") == "W(0) T");
    CHECK(derived("axiom:\nA < B -> C\n").empty());
    CHECK(derived("axiom: A B\nA < B ->\n") == "A");
}

TEST_CASE("what does not end is stopped, and its production is named") {
    const std::string swing = "axiom: A B\nA < B -> C\nA < C -> B\n";
    CHECK(contains(message_of(swing), "production B at line 3 was applied"));
    CHECK(contains(message_of(swing), "steps one inside the other"));
    CHECK(derived(swing, 101) == "A C");
    DeriveOptions few;
    few.max_modules = 1000;
    CHECK(contains(message_of("axiom: A\nA -> A B\nA < B -> C\n", few), "the limit is 1,000 modules"));
    // nothing grows, but every string of a step is looked at
    few.depth = 1'000'000;
    CHECK(contains(message_of(swing, few), "the limit is 1,000 modules"));
}

TEST_CASE("decompositions come before contexts are looked at, homomorphisms behind them") {
    const std::string body =
        "axiom: P Q\n"
        "decomposition P -> A B\n"
        "B < Q -> R(1)\n"
        "R(n) : n < 3 -> R(n+1)\n"
        "homomorphism R(n) -> f(n) Dot\n"
        "terminal Dot: path \"M0 0H1V1Z\"\n";
    CHECK(derived(body) == "A B R(3)");
    const std::vector<Placement> placements = interpret(grammar_of(body));
    REQUIRE(placements.size() == 1);
    CHECK(placements.front().pose.translation == Point{0, 3});
}

TEST_CASE("without a context that fits, deriving in steps gives what deriving depth first gives, to the bit") {
    const std::string terminals = "terminal A: path \"M0 0H1V1Z\"\nterminal B: path \"M0 0H2V1Z\"\n";
    const std::vector<std::string> bodies{
        "axiom: P(4) [ P(2) ] B\nP(m) : m > 0 -> [ A ] f(13) P(m-1)\n" + terminals,
        "axiom: T(5)\nT(n) : n > 0 -> [ +(uniform(10, 40)) f(n) T(n-1) ] f(1) [ -(normal(20, 5)) T(n-1) ] A : 2\n"
        "T(n) : n > 0 -> f(2) T(n-1) B : n\nT(n) -> A\n" +
            terminals,
        "axiom: S(3, 1)\ndecomposition S(n, k) : n > 0 -> A f(k) S(n-1, k*2) T(k)\nT(k) : k > 1 -> T(k/2) [ | B ]\n"
        "homomorphism T(k) -> *(1/k) A f(uniform(0, k)) B\n" +
            terminals};
    for (const std::string& body : bodies) {
        const auto as_usual = interpret(grammar_of(body), {.addresses = true, .trails = true});
        const auto stepwise = interpret(in_steps(body), {.addresses = true, .trails = true});
        REQUIRE(as_usual.size() == stepwise.size());
        REQUIRE(!as_usual.empty());
        for (std::size_t i = 0; i < as_usual.size(); ++i) CHECK(same_placement(as_usual[i], stepwise[i]));
        for (const int depth : {0, 1, 2, 3, -1}) {
            DeriveOptions options;
            options.depth = depth;
            CHECK(to_text(derive(grammar_of(body), options)) == to_text(derive(in_steps(body), options)));
        }
    }
}

TEST_CASE("a symbol that waits draws anew in every step") {
    // half of what is left goes in each step
    std::string body = "axiom:";
    constexpr int symbols = 1000;
    for (int i = 0; i < symbols; ++i) body += i % 10 == 9 ? " X\n " : " X";
    body += "\nignore X\nX : uniform(0, 1) < 0.5 -> Y\nX < Y -> Y\n";
    const auto left_after = [&](int steps) {
        const std::string text = derived(body, steps);
        return std::count(text.begin(), text.end(), 'X');
    };
    CHECK(left_after(1) == Approx(500).margin(80));
    CHECK(left_after(4) == Approx(62).margin(32));
    CHECK(left_after(4) < left_after(3));
    CHECK(derived(body, 3) == derived(body, 3));
}

TEST_CASE("weights choose among the productions whose contexts fit") {
    const std::string body =
        "axiom: L S L S L S L S L S L S L S L S R S\n"
        "L < S -> A : 1\nL < S -> B : 1\nR < S -> C : 1000\n";
    const std::string text = derived(body);
    CHECK(std::count(text.begin(), text.end(), 'C') == 1);
    CHECK(std::count(text.begin(), text.end(), 'A') + std::count(text.begin(), text.end(), 'B') == 8);
}

TEST_CASE("a mistake in a context says what and where") {
    CHECK(contains(message_of("axiom: A(1) B\nA < B -> C\n"), "3:1: expected 1 parameter(s) of the context A"));
    CHECK(contains(message_of("axiom: A B\nA < B -> C\nexcept 1 -> B\n"), "4:1: expected a grammar without exceptions"));
    CHECK(contains(message_of("axiom: A(1) B\nA(n) < B -> C(1/(n-1))\n"), "expected finite arguments of C"));
    CHECK(contains(message_of("axiom: A B\nA < B -> C ]\nterminal C: path \"M0 0H1\"\n"), "nothing was wrong"));
    CHECK_THROWS_AS(interpret(grammar_of("axiom: A B\nA < B -> C ]\n")), InputError);
}

TEST_CASE("contexts are found in a time that grows with the string, not with its square") {
    // each symbol's left context lies past all branches before it
    std::string body = "axiom: A";
    constexpr int branches = 20'000;
    for (int i = 0; i < branches; ++i) body += i % 16 == 15 ? " [ S ]\n " : " [ S ]";
    const std::string text = derived(body + "\nA < S -> T\nS > A -> U\n");
    CHECK(std::count(text.begin(), text.end(), 'T') == branches);
}

TEST_CASE("a derivation with contexts that does not end can be stopped") {
    struct Stopped {};
    int calls = 0;
    const Progress stop_soon = [&](std::string_view, double done) {
        CHECK(done >= 0);
        CHECK(done <= 1);
        if (++calls > 5) throw Stopped{};
    };
    DeriveOptions options;
    options.max_modules = 100'000;  // which is reached before anything is interpreted
    CHECK_THROWS_AS(derive(in_steps("axiom: A\nA -> A A\n"), options, stop_soon), Stopped);
}
