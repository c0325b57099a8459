// Mistakes in how productions work together, hints, and several mistakes in one statement.

#include <catch2/catch.hpp>

#include "lsystem/grammar_text.h"

using namespace rinceau;

using Texts = std::vector<std::string>;

static Texts places_of(const std::vector<Warning>& warnings) {
    Texts places;
    for (const Warning& warning : warnings)
        places.push_back(std::to_string(warning.place.line) + ':' + std::to_string(warning.place.column));
    return places;
}
static Texts mistakes(const std::string& body) { return places_of(check_grammar("lsystem 1\n" + body)); }

/// The message of the only mistake.
static std::string message(const std::string& body) {
    const std::vector<Warning> found = check_grammar("lsystem 1\n" + body);
    REQUIRE(found.size() == 1);
    return found[0].message;
}
static bool says(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

static const std::string drawn = "terminal X: path \"M0 0V-1\"\nterminal Y: path \"M0 0V-1\"\n";

TEST_CASE("weights are not below 0, and not all 0") {
    CHECK(mistakes("axiom: A\nA -> X : 2\nA -> Y : 0\n" + drawn).empty());
    CHECK(mistakes("axiom: A\nA -> X : 2\nA -> Y : -1\n" + drawn) == Texts{"4:1"});
    CHECK(mistakes("axiom: A\nA -> X : 1/0\nA -> Y : 1\n" + drawn) == Texts{"3:1"});
    CHECK(says(message("axiom: A\nA -> X : 0\nA -> Y : 1-1\n" + drawn), "expected a weight above 0 among those of A"));
}

TEST_CASE("weighted and unweighted productions that hide one another are mistakes") {
    CHECK(says(message("axiom: A\nA -> X\nA -> Y : 1\n" + drawn),
               "the one in line 3 always comes first; give that one a weight"));
    CHECK(says(message("axiom: A\nA -> X : 1\nA -> Y\n" + drawn),
               "the one in line 3 always comes first; give this one a weight"));
    CHECK(mistakes("axiom: A B A\nB < A -> X\nA -> Y\nB -> Y\n" + drawn).empty());
    CHECK(mistakes("axiom: A(1)\nA(m) : m > 1 -> X\nA(m) -> Y : 1\nA(m) -> X : 1\n" + drawn).empty());
    // the first one brings in the last one, although the one between them has no weight
    CHECK(mistakes("axiom: A(1)\nA(m) : m > 1 -> X : 1\nA(m) -> Y\nA(m) -> X : 1\n" + drawn).empty());
}

TEST_CASE("a rewriting of what is decomposed at once never applies") {
    CHECK(says(message("axiom: A\nA -> X\ndecomposition A -> Y\n" + drawn), "A is decomposed at once by the one in line 4"));
    CHECK(mistakes("axiom: A(1)\nA(m) -> X\ndecomposition A(m) : m > 1 -> Y\n" + drawn).empty());
    CHECK(mistakes("axiom: A\nA -> X\nhomomorphism A -> Y\n" + drawn).empty());
}

TEST_CASE("productions that never end are mistakes, by whatever way they come back") {
    CHECK(says(message("axiom: A\nA -> B\nB -> [C] f(1)\nC -> A X\n" + drawn),
               "found A in its own successor by way of B and C without a condition: add one, such as ': m > 0', or derive"));
    for (const std::string kind : {"decomposition ", "homomorphism "}) {
        CHECK(says(message("axiom: A\n" + kind + "A -> X A\n" + drawn), "expected a " + kind + "that ends, found A"));
        CHECK(mistakes("axiom: A(3)\n" + kind + "A(m) : m > 0 -> X A(m-1)\n" + drawn).empty());
    }
    // each of the weighted ones comes back
    CHECK(mistakes("axiom: A\nA -> A X : 1\nA -> B : 2\nB -> A\n" + drawn) == Texts{"3:1"});
    // one of them is a way out
    CHECK(mistakes("axiom: A\nseed 1\nA -> A X : 1\nA -> X : 2\n" + drawn).empty());
    // of different kinds: A is drawn as X A's once only
    CHECK(mistakes("axiom: A\nhomomorphism A -> X B\nB -> A\n" + drawn).empty());
    CHECK(mistakes("axiom: A(1)\nA(m) -> A(m, 1)\nA(m, k) -> X\n" + drawn).empty());
}

TEST_CASE("contexts that are never met are mistakes") {
    const std::string rest = drawn + "A -> X\n";
    CHECK(mistakes("axiom: X A Y\nX < A > Y -> X\n" + rest).empty());
    CHECK(says(message("axiom: X A Y\nXx < A -> X\n" + rest), "found 'Xx', which stands in none"));
    CHECK(says(message("axiom: X A Windows Y\nWindow < A -> X\nWindows -> X\n" + rest), "(did you mean 'Windows'?)"));
    CHECK(says(message("axiom: X A Y\nA > Y(m) -> X\n" + rest),
               "expected 0 parameter(s) of Y, as it stands in the strings, found 1"));
    CHECK(says(message("axiom: X A Y\nignore Y\nA > Y -> X\n" + rest), "take it away from 'ignore'"));
    CHECK(says(message("axiom: X A D Y\nA > D -> X\ndecomposition D -> Y\n" + rest), "which is decomposed at once"));
    // only drawn, by a homomorphism
    CHECK(mistakes("axiom: X A H\nA > Y -> X\nhomomorphism H -> Y\n" + rest) == Texts{"3:5"});
}

TEST_CASE("contexts and exceptions, and ignored symbols that are nowhere, are mistakes") {
    CHECK(says(message("axiom: X A\nX < A -> X\nexcept 1 ->\n" + drawn + "A -> X\n"),
               "expected no exceptions in a grammar with contexts"));
    CHECK(mistakes("axiom: X A\nX < A -> X\nignore Y\n   Nowhere\n" + drawn + "A -> X\n") == Texts{"4:8", "5:4"});
}

TEST_CASE("a symbol that only contexts see needs no drawing") {
    CHECK(mistakes("axiom: Mark A\nMark < A -> X\nA -> Y\n" + drawn).empty());
    CHECK(mistakes("axiom: Mark A\nA -> Y\n" + drawn) == Texts{"2:8"});
}

TEST_CASE("each mistake of a statement is named") {
    CHECK(mistakes("axiom: X(1 Y $ % X\n" + drawn) == Texts{"2:19"});
    CHECK(mistakes("axiom: f(1/) $$$ X &Y * * f(?, 1) X\n" + drawn) ==
          Texts{"2:12", "2:14", "2:20", "2:23", "2:25", "2:27", "2:29"});
    CHECK(mistakes("axiom: A\nA(m) : m > ( -> f(k+j) $ : x\n" + drawn) ==
          Texts{"2:8", "3:1", "3:14", "3:17", "3:17", "3:24"});
    CHECK(mistakes("axiom: X\nA(m B -> f(1, ] $ C\n" + drawn) == Texts{"3:5", "3:20"});
    CHECK(mistakes("axiom: X\nexcept 1.0.2 -> f(1 2) $\n" + drawn) == Texts{"3:10", "3:21", "3:24"});
    CHECK(
        mistakes("axiom: X\nstyle 1: fil red; fill rot; stroke-width; stroke red green; fill none; opacity 7; opacity 1\n" +
                 drawn) == Texts{"3:10", "3:24", "3:41", "3:54", "3:61", "3:80", "3:83"});
    CHECK(mistakes("axiom: X\nterminal A: style x; path \"M0;0\"; ix; id \"a;b\" 3; box 1 2 3 0; styl 3\n" + drawn) ==
          Texts{"3:19", "3:30", "3:35", "3:48", "3:51", "3:64"});
}

TEST_CASE("a statement that cannot be read spoils no others") {
    CHECK(
        mistakes("axiom: A(1) B C D(n)\nA(m -> X\ndefine n - 3\nterminal B\nC(, -> X\nD(m) : -> X\nexcept 1.1.1 $ -> B\n") ==
        Texts{"3:5", "4:10", "5:11", "6:3", "7:8", "7:11", "8:14"});
}

TEST_CASE("a name that is nearly a known one is asked for") {
    CHECK(says(message("axiom: windw\nterminal Window: path \"M0 0\"\n"), "'windw' (did you mean 'Window'?)"));
    CHECK(says(message("axiom: WINDOW\nterminal Window: path \"M0 0\"\n"), "(did you mean 'Window'?)"));
    CHECK_FALSE(says(message("axiom: Door\nterminal Window: path \"M0 0\"\n"), "did you mean"));
    CHECK(says(message("axiom: A(1)\nA(count) -> f(cuont) X\n" + drawn), "(did you mean 'count'?)"));
    CHECK(says(message("axiom: X f(sine(3))\n" + drawn), "(did you mean 'sin'?)"));
    CHECK(says(message("axiom: X\nstyle 1: stroke-with 2\n" + drawn), "(did you mean 'stroke-width'?)"));
    CHECK(says(message("axiom: X\nterminal Z: pth \"M0 0\"\n" + drawn), "(did you mean 'path'?)"));
    for (const char* statement :
         {"difine n = 3", "Define n = 3", "axion: X", "Title \"x\"", "uses \"a\"", "sed 7", "teminal Z: path \"M0 0\""})
        CHECK(says(message("axiom: X\n" + std::string(statement) + "\n" + drawn), "did you mean"));
    CHECK(says(message("axiom: A X\ndecompositon A -> X\nA -> X\n" + drawn), "(did you mean 'decomposition'?)"));
}

TEST_CASE("hints name what nothing uses, in grammars without mistakes") {
    const auto hints = [](const std::string& body) { return inspect_grammar("lsystem 1\n" + body).hints; };
    const std::string used =
        "define n = 1\naxiom: A(n) ;(m) X\ndefine m = n\nA(k) -> X\nstyle 1: fill red\nterminal X: style 1\n";
    CHECK(hints(used).empty());
    CHECK(places_of(hints("ignore X\n" + used + "define o = m\nB(n) -> Y(1)\nterminal Y:\nY(n) -> X\n")) ==
          Texts{"1:1", "9:8", "10:1", "10:1", "11:10", "12:1", "12:1"});
    CHECK(places_of(
              hints("axiom: X ;(2) X\nstyle 1: fill red\nstyle 2: fill red\nstyle 3: fill red\nterminal X: style 1\n")) ==
          Texts{"5:7"});
    CHECK(hints(used + "axiom: A\n").empty());  // a mistake is there
}

TEST_CASE("a text full of mistakes is given up in bounded time") {
    std::string text = "axiom: ";
    for (int i = 0; i < 100'000; ++i) text += "$ Xx(1/0) ";
    const std::vector<Warning> found = check_grammar("lsystem 1\n" + text + '\n' + drawn);
    CHECK(found.size() == 1001);
    CHECK(says(found.back().message, "more"));
}

TEST_CASE("long chains and circles of productions are followed in linear time") {
    std::string chain = "axiom: A0\n", circle = chain;
    constexpr int count = 20'000;
    for (int i = 0; i < count; ++i) {
        const std::string head = "A" + std::to_string(i) + " -> f(1) A";
        chain += head + std::to_string(i + 1) + '\n';
        circle += head + std::to_string((i + 1) % count) + '\n';
    }
    CHECK(mistakes(chain + "A20000 -> X\n" + drawn).empty());
    CHECK(mistakes(circle + drawn) == Texts{"3:1"});
}
