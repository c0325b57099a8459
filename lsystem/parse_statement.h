#pragma once
// One statement of a grammar's text becomes a part of the grammar. Internal to the folder.

#include <map>
#include <span>
#include <string>
#include <string_view>

#include "lsystem/grammar.h"
#include "lsystem/statement.h"

namespace rinceau {

/// What the statements before have given.
struct ParseState {
    Grammar grammar;
    bool versioned = false;
    std::map<std::string, int> lines;  ///< of what may stand only once: "title", "terminal A", ..
};

/// Words that begin statements and therefore cannot be symbols.
std::span<const std::string_view> statement_words();

/// Adds the statement to the grammar. Throws InputError; then the grammar is as before, or lacks what is at fault.
void parse_statement(const Statement& statement, ParseState& state);

}  // namespace rinceau
