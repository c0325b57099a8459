#include "lsystem/unfolded_exceptions.h"

#include <catch2/catch.hpp>

#include "lsystem/flat_grammar.h"
#include "lsystem/grammar_text.h"
#include "lsystem/interpret.h"
#include "tests/lsystem/random_grammar.h"

using namespace rinceau;

static Grammar grammar_of(const std::string& body) { return parse_grammar("lsystem 1\n" + body); }

static std::string axiom_of(const Grammar& grammar) {
    Grammar axiom;
    axiom.axiom = grammar.axiom;
    const std::string text = to_text(axiom);
    return text.substr(text.find("axiom: ") + 7);
}

static const std::string tree =
    "axiom: R(3) B\n"
    "R(m) : m > 0 -> [A] [-(17) f(64) *(0.8) R(m-1)] [+(7) f(181) *(0.6) R(m-1)]\n"
    "R(m) : m == 0 -> [A]\nB -> [C] f(1) [D(2)]\nD(m) : m > 0 -> A f(2) D(m-1)\n";

TEST_CASE("a grammar without exceptions stays as it is") {
    const Grammar grammar = grammar_of(tree);
    CHECK(same_grammar(unfolded_exceptions(grammar), grammar));
}

TEST_CASE("only what leads to an exception is unfolded") {
    const Grammar grammar = grammar_of(tree + "except 2.2.2 -> C C\n");
    const Grammar unfolded = unfolded_exceptions(grammar);
    CHECK(unfolded.exceptions.empty());
    CHECK(axiom_of(unfolded) == "R(3) [C] f(1) [A f(2) C C f(2) D(0)]\n");
    CHECK(to_text(derive(unfolded)) == to_text(derive(grammar)));
}

TEST_CASE("an exception in a sequence leaves the rest of the sequence") {
    const Grammar grammar = grammar_of("axiom: P(100)\nP(m) : m > 0 -> [A] f(m) P(m-1)\nexcept 1.3 ->\n");
    CHECK(axiom_of(unfolded_exceptions(grammar)) == "[A] f(100) [A] f(99) [] f(98) P(97)\n");
}

TEST_CASE("numbers that are counted across the branches of a tree find their branch") {
    const std::string plain = to_text(derive(grammar_of(tree)));
    for (int number = 1; number <= 15; ++number) {
        const Grammar grammar = grammar_of(tree + "except 1." + std::to_string(number) + " -> C\n");
        const Grammar unfolded = unfolded_exceptions(grammar);
        const std::string text = to_text(derive(unfolded));
        CHECK(text == to_text(derive(grammar)));
        CHECK(text != plain);
        CHECK(axiom_of(unfolded).find("R(") != std::string::npos);
    }
}

TEST_CASE("exceptions inside what an exception puts in place are unfolded too") {
    const Grammar grammar = grammar_of(tree + "except 2.2 -> +(5) D(3)\nexcept 2.2.2 -> C\n");
    const Grammar unfolded = unfolded_exceptions(grammar);
    CHECK(axiom_of(unfolded) == "R(3) [C] f(1) [+(5) A f(2) C f(2) D(1)]\n");
    CHECK(to_text(derive(unfolded)) == to_text(derive(grammar)));
}

TEST_CASE("a limit of depth becomes a count in the rules") {
    for (int depth = 0; depth < 6; ++depth) {
        for (const char* exception : {"", "except 2.2.1 -> f(1) C\n", "except 1.4 -> R(2)\n", "except 2 -> [B] C\n"}) {
            const Grammar grammar = grammar_of(tree + exception + "terminal R: path \"M0 0H1\"\nterminal A:\n");
            const Grammar unfolded = unfolded_exceptions(grammar, {.depth = depth});
            const auto wanted = interpret(grammar, {.derive = {.depth = depth}});
            const auto found = interpret(unfolded);
            REQUIRE(found.size() == wanted.size());
            for (std::size_t i = 0; i < wanted.size(); ++i) {
                CHECK(found[i].terminal == wanted[i].terminal);
                CHECK(found[i].pose == wanted[i].pose);
            }
        }
    }
}

/// Letters that are rewritten m - 1 times among letters that stay, so that every address depth occurs.
static std::string random_successor(Random& random, const std::string& count) {
    std::string text;
    for (std::uint32_t i = 1 + random.below(4); i > 0; --i) {
        const bool rewritten = random.below(2) == 0;
        text += random.below(3) == 0 ? " [f(2) " : " [";
        text += rewritten              ? std::string("PQR").substr(random.below(3), 1) + '(' + count + ')'
                : random.below(2) == 0 ? "A"
                                       : "B";
        text += ']';
    }
    return text;
}

static Grammar random_tree(Random& random) {
    std::string body = "axiom:" + random_successor(random, "3") + '\n';
    for (const char* symbol : {"P", "Q", "R"}) {
        body += std::string(symbol) + "(m) : m > 0 ->" + random_successor(random, "m-1") + '\n';
    }
    for (std::uint32_t i = 1 + random.below(3); i > 0; --i) {
        body += "except " + std::to_string(1 + random.below(3));
        for (std::uint32_t k = random.below(4); k > 0; --k) body += '.' + std::to_string(1 + random.below(5));
        body += " ->" + (random.below(4) == 0 ? std::string() : random_successor(random, "2")) + '\n';
    }
    return grammar_of(body);
}

TEST_CASE("unfolding changes no string") {
    Random random(5);
    int changed = 0;
    for (int i = 0; i < 500; ++i) {
        const Grammar grammar = random_tree(random);
        Grammar regular = grammar;
        regular.exceptions.clear();
        const std::string wanted = to_text(derive(grammar));
        changed += wanted != to_text(derive(regular));
        const Grammar unfolded = unfolded_exceptions(grammar);
        CAPTURE(to_text(grammar), to_text(unfolded));
        REQUIRE(unfolded.exceptions.empty());
        REQUIRE(to_text(derive(unfolded)) == wanted);
    }
    CHECK(changed > 100);
}

TEST_CASE("the flat grammar draws the same in the same order") {
    const Grammar grammar = grammar_of(
        "canvas 0 0 9 9\naxiom: P(9) [z(2) A] | ;(2) P(3)\n"
        "P(m) : m > 0 -> [z(m-2*floor(m/2)) A] +(13*m) f(2) *(0.9) | [;(1) A] P(m-1)\nexcept 1.2 -> f(-1) A\n"
        "style 1: fill none\nstyle 2: fill red\nterminal A: path \"M0 0H1\"\n");
    const Grammar flat = flat_grammar(grammar);
    CHECK(flat.productions.empty());
    CHECK(flat.exceptions.empty());
    const auto wanted = interpret(grammar);
    const auto found = interpret(flat);
    REQUIRE(found.size() == wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        CHECK(found[i].terminal == wanted[i].terminal);
        CHECK(found[i].style == wanted[i].style);
        CHECK(found[i].layer == 0);
        CHECK(found[i].pose.mirrored == wanted[i].pose.mirrored);
        CHECK(abs(found[i].pose.linear - wanted[i].pose.linear) < 1e-14);
        CHECK(abs(found[i].pose.translation - wanted[i].pose.translation) < 1e-13);
    }
}
