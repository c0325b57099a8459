#pragma once
// What the verbs have in common that change a grammar: the edit is checked, said and written.

#include <string>

#include <CLI/App.hpp>

#include "lsystem/derive.h"
#include "lsystem/edit_result.h"

namespace rinceau {

/// What an edit reads and writes.
struct EditFiles {
    std::string input;
    std::string
        output;  ///< .lsys; or .svg, .png, .pdf: the picture of the edited grammar; empty = grammar to standard output
    DeriveOptions derive;
};

/// RULES, -o, and the options of derivation.
void add_edit_options(CLI::App& verb, EditFiles& files);

/// Throws CLI::ValidationError or OutputError if the output's name is none.
void expect_edit_output(const EditFiles& files);

/// By the output's ending.
void write_grammar_or_picture(const Grammar& grammar, const EditFiles& files);

/// The grammar as it is written. Throws as read_input() and parse_grammar(), and CLI::ValidationError or OutputError if the
/// output's name is none.
Grammar read_for_edit(const EditFiles& files);

/// Checks the edit (check_edit.h), says on standard error what is different now, and writes it.
void write_edit(const Grammar& before, EditResult edit, const EditFiles& files);

}  // namespace rinceau
