#include "lsystem/edit_styles.h"

#include <catch2/catch.hpp>

#include "lsystem/grammar_text.h"
#include "lsystem/interpret.h"

using namespace rinceau;

namespace {

const std::string drawing =
    "lsystem 1\naxiom: A B ;(2) C\nstyle 1: fill #ff0000\nstyle 2: fill #00ff00\n"
    "terminal A: style 1; path \"M0 0H1\"\nterminal B: style 1; path \"M0 0H2\"\nterminal C: style 2; path \"M0 0H3\"\n";

const Style blue{.fill = Color{0, 0, 255}};

Paint fill_of(const Grammar& grammar, const std::string& symbol) {
    for (const Terminal& terminal : grammar.terminals)
        for (const NumberedStyle& style : grammar.styles)
            if (terminal.symbol == symbol && style.number == terminal.style) return style.style.fill;
    return NoPaint{};
}

}  // namespace

TEST_CASE("a terminal is painted alone or with all that share its style") {
    const Grammar grammar = parse_grammar(drawing);
    CHECK(sharing_style(grammar, "A") == std::vector<std::string>{"A", "B"});
    const Grammar alone = restyle_terminal(grammar, "A", blue, RestyleWhat::only_this).grammar;
    CHECK(fill_of(alone, "A") == Paint{Color{0, 0, 255}});
    CHECK(fill_of(alone, "B") == Paint{Color{255, 0, 0}});
    const Grammar all = restyle_terminal(grammar, "A", blue, RestyleWhat::all_that_share).grammar;
    CHECK(fill_of(all, "B") == Paint{Color{0, 0, 255}});
    CHECK(all.styles.size() == grammar.styles.size());
    // painted alone again, the style of its own is changed
    const Grammar again = restyle_terminal(alone, "A", {}, RestyleWhat::only_this).grammar;
    CHECK(again.styles.size() == alone.styles.size());
}

TEST_CASE("a style that a string chooses stays for the string") {
    const Grammar grammar = parse_grammar(drawing);
    const Grammar painted = restyle_terminal(grammar, "C", blue, RestyleWhat::only_this).grammar;
    CHECK(painted.styles.size() == grammar.styles.size() + 1);
    CHECK(painted.styles[1].style.fill == Paint{Color{0, 255, 0}});
}

TEST_CASE("the same style again is no change, and what is no terminal is refused") {
    const Grammar grammar = parse_grammar(drawing);
    CHECK(restyle_terminal(grammar, "A", grammar.styles[0].style, RestyleWhat::only_this).changes.empty());
    CHECK_THROWS_AS(restyle_terminal(grammar, "Q", blue, RestyleWhat::only_this), InputError);
}
