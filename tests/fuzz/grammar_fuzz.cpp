// Grammars in JSON: what is read is written as JSON and as text, and reads back from both.

#include "exports/json_grammar.h"
#include "lsystem/grammar_text.h"
#include "tests/fuzz/fuzz_target.h"

void rinceau::take_input(std::string_view bytes) {
    const Grammar grammar = parse_json_grammar(bytes, "any.json");
    const std::string json = to_json(grammar).bytes, text = to_text(grammar);
    require(is_taken([&] {
                require(to_json(parse_json_grammar(json)).bytes == json, "JSON that is written reads back as the same");
                require(to_text(parse_grammar(text)) == text, "text that is written reads back as the same");
            }),
            "a grammar that is written can be read");
}
