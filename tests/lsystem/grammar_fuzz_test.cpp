// Texts that are spoilt at random are read, or refused with a message; nothing else happens.

#include <catch2/catch.hpp>

#include "lsystem/grammar_text.h"
#include "lsystem/interpret.h"
#include "random_grammar.h"

using namespace rinceau;

static std::string spoilt(Random& random, std::string text) {
    static constexpr std::string_view characters = "()[]{}+-*/^<>=!&|;:,.#\"\\\n\t 09aAfzPm_~\x80";
    for (std::uint32_t i = 1 + random.below(4); i > 0 && !text.empty(); --i) {
        const std::size_t at = random.below(static_cast<std::uint32_t>(text.size()));
        const std::size_t length = random.below(12);
        const char character = characters[random.below(static_cast<std::uint32_t>(characters.size()))];
        switch (random.below(5)) {
            case 0:
                text.erase(at, length);
                break;
            case 1:
                text.insert(at, 1, character);
                break;
            case 2:
                text[at] = character;
                break;
            case 3:
                text.insert(at, text.substr(random.below(static_cast<std::uint32_t>(text.size())), 4 * length));
                break;
            default:
                text.resize(at);
        }
    }
    return text;
}

static void read_and_draw(const std::string& text, int& read, int& refused) {
    InterpretOptions options{.addresses = true};
    options.derive.max_modules = 2000;
    options.derive.max_recursion = 500;
    try {
        const Grammar grammar = parse_grammar(text);
        ++read;
        REQUIRE(same_grammar(parse_grammar(to_text(grammar)), grammar));
        interpret(grammar, options);
    } catch (const InputError& error) {
        ++refused;
        REQUIRE(std::string(error.what()).find("expected") != std::string::npos);
    } catch (const LimitError&) {
        ++refused;
    }
}

TEST_CASE("a spoilt grammar is read or refused, and what is read survives a round trip") {
    Random random(5);
    int read = 0;
    int refused = 0;
    for (int i = 0; i < 1500; ++i) {
        const std::string text = spoilt(random, to_text(random_grammar(random)));
        INFO(text);
        read_and_draw(text, read, refused);
    }
    CHECK(read > 100);
    CHECK(refused > 100);
}

TEST_CASE("check accepts no text that reading refuses") {
    Random random(6);
    for (int i = 0; i < 150; ++i) {
        const std::string text = spoilt(random, to_text(random_grammar(random)));
        INFO(text);
        bool refused = false;
        try {
            parse_grammar(text);
        } catch (const InputError&) {
            refused = true;
        }
        const bool clean = check_grammar(text).empty();
        CHECK_FALSE((refused && clean));
    }
}
