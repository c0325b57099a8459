#include <catch2/catch.hpp>

#include "lsystem/grammar_text.h"

using namespace rinceau;

/// "line:column" of every mistake.
static std::vector<std::string> mistakes(const std::string& text) {
    std::vector<std::string> places;
    for (const Warning& warning : check_grammar(text, "x.lsys")) {
        CHECK(warning.message.starts_with("expected"));
        CHECK(warning.place.file == "x.lsys");
        places.push_back(std::to_string(warning.place.line) + ':' + std::to_string(warning.place.column));
    }
    return places;
}

using Texts = std::vector<std::string>;

static const std::string good =
    "lsystem 1\n"
    "axiom: P(3)\n"
    "P(m) : m > 0 -> [A] f(13) P(m-1)\n"
    "terminal A: path \"M0 0L1 1\"\n";

TEST_CASE("a good grammar has no mistakes") {
    CHECK(mistakes(good).empty());
    CHECK(mistakes(good + "except 1.2 -> *(2) A\n").empty());
    CHECK(mistakes("lsystem 1\naxiom: R(2)\nR(m) : m == 0 -> A\nR(m) -> A R(m-1)\nterminal A:\n").empty());
}

TEST_CASE("a stroke of fixed width has no pen") {
    CHECK(mistakes(good + "style 1: stroke red; stroke-width 2 fixed\n").empty());
    CHECK(mistakes(good + "style 1: stroke-width 2 fixed; pen 2 0 0 1\n") == Texts{"5:32"});
    CHECK(mistakes(good + "style 1: pen 2 0 0 1; stroke-width 2 fixed\n") == Texts{"5:23"});
    CHECK(mistakes(good + "style 1: stroke-width 2 fix\n").size() == 1);
}

TEST_CASE("every mistake is named in order, not only the first") {
    CHECK(mistakes("lsystem 1\n"
                   "axiom: [P(3) f f(n) Q ]\n"
                   "P(m) : m > 0 -> [A f(13, 2) P(m-1\n"
                   "P(m) : k > 0 -> ] A [\n"
                   "style 1: fil red\n"
                   "terminal A: style 7; path \"M0 0L1\"\n"
                   "terminal A: style 7\n"
                   "terminal B\n") ==
          Texts{"2:14", "2:16", "2:21", "3:20", "3:34", "4:1", "4:17", "4:21", "5:10", "6:10", "6:34", "7:10", "8:11"});
}

TEST_CASE("numbers that a command does not take are mistakes") {
    CHECK(mistakes(good + "except 1.1 -> *(0) z(0.5) ;(4) f(1/0) A\n") == Texts{"5:15", "5:20", "5:27", "5:32"});
}

TEST_CASE("productions that never apply or never end are mistakes") {
    CHECK(mistakes("lsystem 1\naxiom: P(1)\nP(m) -> A\nP(m) : m > 1 -> A A\nterminal A:\n") == Texts{"4:1"});
    CHECK(mistakes("lsystem 1\naxiom: P(1)\nP(m) : 1 > 2 -> A\nterminal A:\n") == Texts{"3:1"});
    CHECK(mistakes("lsystem 1\naxiom: A\nA -> A f(1) A\nterminal A:\n") == Texts{"3:1"});
}

TEST_CASE("what only shows when it is derived is a mistake too") {
    CHECK(mistakes(good + "except 1.4 -> A\nexcept 1.2 -> A\n") == Texts{"5:1"});
    CHECK(mistakes(good + "except 1.2 -> A\nexcept 1.2 ->\n") == Texts{"6:1"});
    CHECK(mistakes("lsystem 1\naxiom: P(2)\nP(m) : m > 0 -> f(1/(m-1)) P(m-1)\n") == Texts{"3:17"});
    const auto endless = check_grammar("lsystem 1\naxiom: P(0.5)\nP(m) : m != 0 -> f(1) P(m-1)\n");
    REQUIRE(endless.size() == 1);
    CHECK(endless[0].place.line == 3);
    CHECK(endless[0].message.find("100,001 times") != std::string::npos);
}

TEST_CASE("an empty text and an empty axiom are mistakes") {
    CHECK(mistakes("") == Texts{"1:1", "1:1"});
    CHECK(mistakes("lsystem 1\n") == Texts{"1:1"});
    CHECK(mistakes("lsystem 1\naxiom: A A(\n") == Texts{"2:8", "2:12"});
}

TEST_CASE("check finds a mistake wherever reading does") {
    for (const char* text :
         {"lsystem 1\naxiom: A $", "lsystem 3", "lsystem 1\ntitle \"x", "lsystem 1\n  indented", "axiom: A"}) {
        INFO(text);
        CHECK_THROWS_AS(parse_grammar(text), InputError);
        CHECK_FALSE(check_grammar(text).empty());
    }
}
