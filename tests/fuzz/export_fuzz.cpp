// L-systems in the languages of other programs.

#include "exports/export_formats.h"
#include "lsystem/grammar_text.h"
#include "tests/fuzz/fuzz_target.h"

void rinceau::take_input(std::string_view bytes) {
    const Grammar grammar = parse_grammar(bytes, "any.lsys");
    ExportOptions options;
    options.derive.max_modules = 500;
    options.derive.max_recursion = 50;
    derive(grammar, options.derive);  // what is long is refused here: exports look at the whole derivation more than once
    for (const ExportFormat& format : export_formats())
        for (const bool live : {false, true}) {
            options.live_random = live;
            is_taken([&] { require(!format.write(grammar, options).bytes.empty(), "an export says something"); });
        }
}
