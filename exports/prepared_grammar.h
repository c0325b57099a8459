#pragma once
// A grammar brought to what programs for L-systems have in common: no exceptions, no limit of depth, no style commands,
// nothing drawn by chance. Internal to the folder.

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "exports/export.h"

namespace rinceau {

struct PreparedGrammar {
    Grammar grammar;
    bool styled = false;  ///< every symbol has the number of the style in force as its last argument
    std::vector<std::string> notes;
};

/// Thrown where rules cannot be written; `reason` follows a colon: "a style is in force beyond the symbol that sets it".
struct RulesLost {
    std::string reason;
};

/// `write` with the rules kept, or, where it or the preparation throws RulesLost, with every placement by itself
/// (lsystem/flat_grammar.h) and a note why. `format` begins the notes: "L-Py". Throws as derive(), and InputError if nothing
/// but fragments of SVG would be drawn.
Export write_prepared(const Grammar& grammar, const ExportOptions& options, const std::string& format,
                      const std::function<Export(const PreparedGrammar&)>& write);

/// A style in which a terminal may be drawn.
struct StyleChoice {
    int number = 0;  ///< of the style in force; 0 = the terminal's own
    Style style;
};

/// The terminal's own style, and every other if styles are arguments.
std::vector<StyleChoice> styles_of(const PreparedGrammar& prepared, const Terminal& terminal);

/// All symbols: of modules, productions and terminals, in order of the alphabet.
std::set<std::string> all_symbols(const Grammar& grammar);

/// How many arguments the modules of a symbol have, wherever they stand.
std::set<std::size_t> arities_of(const Grammar& grammar, const std::string& symbol);

bool has_contexts(const Grammar& grammar);

/// Steps of rewriting until nothing is left to rewrite. Throws as derive().
int steps_to_the_end(const Grammar& grammar, const DeriveOptions& options);

}  // namespace rinceau
