#pragma once
// The .lsys text format (docs/language.md): read, write, check.

#include <string>
#include <string_view>
#include <vector>

#include "lsystem/grammar.h"
#include "lsystem/resolve_uses.h"
#include "scene/input_error.h"

namespace rinceau {

/// Throws InputError (file, line, column, what was expected) at the first mistake.
Grammar parse_grammar(std::string_view text, const std::string& file_name = {});

/// parse_grammar(to_text(g)) gives g again (places aside); numbers in shortest round-trip form.
std::string to_text(const Grammar& grammar);

/// One production, exception or the axiom as it stands in the text: in one line, without comment.
std::string statement_text(const Production& production);
std::string statement_text(const Exception& exception);
std::string axiom_text(const Grammar& grammar);

struct GrammarFindings {
    std::vector<Warning> mistakes;  ///< what was expected, what was found, and the cure; empty = good
    std::vector<Warning> hints;     ///< what is right but perhaps not meant (grammar_hints.h); only without mistakes
};

/// Every mistake in a grammar's text and in the files that it uses, in order of file and place: syntax, unknown symbols and
/// names, wrong numbers of arguments, unbalanced brackets, contexts that are never met, weights that are never drawn,
/// productions that can never apply or never end. Without `load`, a use is a mistake. At most some 1000 mistakes are named.
GrammarFindings inspect_grammar(std::string_view text, const std::string& file_name = {}, const GrammarLoader& load = {});

/// Its mistakes.
std::vector<Warning> check_grammar(std::string_view text, const std::string& file_name = {}, const GrammarLoader& load = {});

}  // namespace rinceau
