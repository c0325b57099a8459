// L-systems: checked, written as text and as JSON, and drawn flat.

#include "exports/json_grammar.h"
#include "lsystem/grammar_text.h"
#include "lsystem/interpret.h"
#include "tests/fuzz/fuzz_target.h"

namespace rinceau {
namespace {

void write_and_read(const Grammar& grammar) {
    const std::string text = to_text(grammar);
    require(to_text(parse_grammar(text)) == text, "a grammar that is written reads back as the same");
    const std::string json = to_json(grammar).bytes;
    require(to_text(parse_json_grammar(json)) == text, "a grammar comes back from JSON");
}

void draw(const Grammar& grammar) {
    InterpretOptions options;
    options.derive.max_modules = 1000;
    options.derive.max_seconds = 1;
    interpret(grammar, options);
}

}  // namespace

void take_input(std::string_view bytes) {
    const bool mistaken = !check_grammar(bytes, "any.lsys").empty();
    Grammar grammar;
    const bool parsed = is_taken([&] { grammar = parse_grammar(bytes, "any.lsys"); });
    require(parsed || mistaken, "what cannot be read has a mistake");
    if (!parsed) return;
    write_and_read(grammar);
    draw(grammar);
}

}  // namespace rinceau
