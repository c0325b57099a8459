#pragma once
// One statement of a grammar's text becomes a part of the grammar. Internal to the folder.

#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lsystem/grammar.h"
#include "lsystem/statement.h"

namespace rinceau {

/// What the statements before have given.
struct ParseState {
    Grammar grammar;
    bool versioned = false;
    std::map<std::string, SourcePlace> first_places;  ///< of what may stand only once: "title", "terminal A", ..
    std::vector<Warning> mistakes;                    ///< as they were found, at most max_mistakes
    std::set<std::string> spoilt;                     ///< names in statements that could not be read
    std::set<std::string> unsure;                     ///< symbols of productions that were read in part
};

/// Words that begin statements and therefore cannot be symbols.
std::span<const std::string_view> statement_words();

/// Adds the statement, or what of it could be read, to the grammar, and its mistakes to the others.
void parse_statement(const Statement& statement, ParseState& state);

}  // namespace rinceau
