#pragma once
// The .lsys text format (docs/language.md): read, write, check.

#include <string>
#include <string_view>
#include <vector>

#include "lsystem/grammar.h"
#include "scene/input_error.h"

namespace rinceau {

/// Throws InputError (file, line, column, what was expected) at the first mistake.
Grammar parse_grammar(std::string_view text, const std::string& file_name = {});

/// parse_grammar(to_text(g)) gives g again (places aside); numbers in shortest round-trip form.
std::string to_text(const Grammar& grammar);

/// Every mistake in a grammar's text, in order of place: syntax, unknown symbols and names, wrong numbers of arguments,
/// unbalanced brackets, productions that can never apply or never end. Empty = good.
std::vector<Warning> check_grammar(std::string_view text, const std::string& file_name = {});

}  // namespace rinceau
