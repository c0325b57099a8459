// Good grammars with a few bits, lines or words changed: reading and checking agree, say what is wrong, and come to an end.

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <ctime>
#include <sstream>

#include "geometry/random.h"
#include "lsystem/grammar_text.h"
#include "lsystem/interpret.h"
#include "random_grammar.h"

using namespace rinceau;

/// Between them they have every statement and every part of one.
static constexpr std::array<std::string_view, 5> good_texts{
    R"(lsystem 1
title "A \"row\""

# at the top
canvas -10 -10 90 40 unsized
seed 18446744073709551615

define count = 4   # a constant
define lean = normal(0, 2)
axiom: [+(lean) Row(count, 1)] [| z(2) ;(1 + count % 2) A]
Row(m, k) : m > 0 && k != 0 -> [A fill(255*m/count, 20, 30) stroke A]
  f(uniform(12, 14)) *(0.9^k) Row(m-1, k)
Row(m, k) : m == 0 || !(k == 1) -> stroke(1, 2, 3) B
except 1.2 -> +(5) A
except 1.3 ->
style 1: fill #ffcc00; stroke gold; stroke-width 2 fixed; stroke-dasharray 1 2 3
style 2: fill linear-gradient(matrix(0 20 -20 0 0 -10), spread repeat, 0 red, 1 navy opacity 0.5); opacity 0.5
terminal A: style 1; path "M-4 0H4V-9Z M0 0c1 2 3 4 5 6"; id "a"
terminal B: style 2; path "M-4 0A4 4 0 0 1 4 0Z"
)",
    R"(lsystem 1
ignore Mark
axiom: Signal(3) Mark Stem [Mark Bud] Stem Stem [Bud] Bud
Signal(t) : t > 0 -> Signal(t-1)
Signal(t) -> Stem
Signal(t) < Stem : t == 0 -> Signal(1)
Signal(t) < Bud > Bud : t == 0 -> Flower
Signal(t) < Bud -> Flower : 0.5
Signal(t) < Bud -> Blade : 2
Nothing -> Bud
Mark -> Mark2 Nothing
Mark2 ->
decomposition Flower -> [Leaf(5)]
decomposition Leaf(n) : n > 0 -> [+(72*n) Blade] Leaf(n-1)
homomorphism Stem -> Line f(3)
homomorphism Signal(t) -> Line f(3)
terminal Line: path "M0 0V-3"
terminal Blade: path "M0 0L3 -3L0 -9Z"
terminal Bud: path "M0 0L3 -3Z"
)",
    R"(lsystem 1
axiom: Tree(5)
Tree(n) : n > 0 -> [+(30) *(0.7) Tree(n-1)] f(3) Tree(n-1) : 3
Tree(n) : n > 0 -> [-(30) *(0.7) Tree(n-1)] f(2) : n
Tree(n) -> Leaf : if(n == 0, 1, hypot(3, clamp(n, 0, 1)))
terminal Leaf: box -4 -12 40 3; verbatim <<<SVG
<text font-size="12">; # "hello"</text>
SVG
# the end
)",
    R"(lsystem 1
use "leaf.lsys" as leaf
use "leaf.lsys"
axiom: leaf_Leaf(leaf_size) Leaf(size)
)",
    R"(lsystem 1
canvas corners -3 -3 4 4
axiom: F(2)
F(n) : n > 0 -> F(n-1) +(60) F(n-1) -(120) F(n-1) +(60) F(n-1)
F(n) : n == 0 -> Line f(1)
style 1: fill none; stroke black; stroke-linecap round; pen 2 0 0 1
terminal Line: style 1; path "M0 0V-1"
)"};

static std::string leaf_file(const std::string&) {
    return "lsystem 1\ndefine size = 3\nLeaf(m) : m > 0 -> ;(m % 2) Blade Leaf(m-1)\nstyle 1: fill red\n"
           "terminal Blade: style 1; path \"M0 0L3 -3L0 -9Z\"\n";
}

static std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

static std::uint32_t size_of(const std::string& text) { return static_cast<std::uint32_t>(text.size()); }

/// The first and one past the last character of the word at or behind a place: a name or number, or one other character.
static std::pair<std::size_t, std::size_t> word_at(const std::string& text, std::size_t at) {
    const auto in_word = [&](std::size_t i) {
        return i < text.size() && (std::isalnum(text[i] & 0x7f) != 0 || text[i] == '_');
    };
    while (at < text.size() && text[at] == ' ') ++at;
    std::size_t begin = at, end = std::min(at + 1, text.size());
    while (in_word(at) && begin > 0 && in_word(begin - 1)) --begin;
    while (in_word(at) && in_word(end)) ++end;
    return {begin, end};
}

static std::string with_words_exchanged(Random& random, const std::string& text) {
    auto first = word_at(text, random.below(size_of(text)));
    auto second = word_at(text, random.below(size_of(text)));
    if (second < first) std::swap(first, second);
    if (second.first < first.second) return text;
    return text.substr(0, first.first) + text.substr(second.first, second.second - second.first) +
           text.substr(first.second, second.first - first.second) + text.substr(first.first, first.second - first.first) +
           text.substr(second.second);
}

static std::string with_line_changed(Random& random, const std::string& text) {
    std::vector<std::string> lines = lines_of(text);
    if (lines.empty()) return text;
    const auto any = [&] { return lines.begin() + random.below(static_cast<std::uint32_t>(lines.size())); };
    switch (random.below(4)) {
        case 0:
            lines.erase(any());
            break;
        case 1:
            std::swap(*any(), *any());
            break;
        case 2:
            lines.insert(any(), std::string(*any()));
            break;
        default:
            *any() += *any();
    }
    std::string result;
    for (const std::string& line : lines) result += line + '\n';
    return result;
}

static std::string mutated(Random& random, std::string text) {
    for (std::uint32_t i = 1 + random.below(3); i > 0 && !text.empty(); --i) {
        const std::size_t at = random.below(size_of(text));
        const auto [begin, end] = word_at(text, at);
        switch (random.below(5)) {
            case 0:
                text[at] = static_cast<char>(text[at] ^ (1 << random.below(8)));
                break;
            case 1:
                text = with_line_changed(random, text);
                break;
            case 2:
                text = with_words_exchanged(random, text);
                break;
            case 3:
                text.erase(begin, end - begin);
                break;
            default:
                text.insert(at, text.substr(begin, end - begin) + ' ');
        }
    }
    return text;
}

/// The first mistake that reading names; empty if it names none.
static std::string mistake_of_reading(const std::string& text) {
    try {
        const Grammar grammar = parse_grammar(text, "x.lsys");
        const std::string written = to_text(grammar);
        const Grammar again = parse_grammar(written);
        REQUIRE(same_grammar(again, grammar));
        REQUIRE(to_text(again) == written);
        return {};
    } catch (const InputError& error) {
        return error.what();
    }
}

TEST_CASE("the grammars that are changed are good ones") {
    for (const std::string_view text : good_texts) {
        INFO(text);
        const std::vector<Warning> mistakes = check_grammar(text, "x.lsys", leaf_file);
        INFO((mistakes.empty() ? "" : located(mistakes[0].place, mistakes[0].message)));
        CHECK(mistakes.empty());
        const Grammar grammar = parse_grammar(text);
        CHECK(to_text(parse_grammar(to_text(grammar))) == to_text(grammar));
    }
}

TEST_CASE("check names what reading names first, and what it calls good is derived") {
    Random random(11);
    int refused = 0, good = 0;
    constexpr int rounds = 1500;
    for (int i = 0; i < rounds; ++i) {
        const std::string text = mutated(random, std::string(good_texts[static_cast<std::size_t>(i) % good_texts.size()]));
        INFO(text);
        const std::string first = mistake_of_reading(text);
        const std::clock_t start = std::clock();
        const std::vector<Warning> mistakes = check_grammar(text, "x.lsys", leaf_file);
        REQUIRE(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC < 10);
        for (const Warning& mistake : mistakes) {
            INFO(mistake.message);
            const bool says_what =
                mistake.message.starts_with("expected") || mistake.message.find("limit") != std::string::npos;
            REQUIRE(says_what);
            REQUIRE(mistake.place.line > 0);
        }
        const bool named = std::ranges::any_of(
            mistakes, [&](const Warning& mistake) { return located(mistake.place, mistake.message) == first; });
        REQUIRE((first.empty() || named));
        refused += !mistakes.empty();
        good += mistakes.empty();
    }
    CHECK(refused > rounds / 4);
    CHECK(good > rounds / 20);
}
