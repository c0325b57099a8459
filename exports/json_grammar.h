#pragma once
// A whole grammar in JSON (docs/grammar.schema.json), and back.

#include <string>
#include <string_view>

#include "exports/export.h"

namespace rinceau {

/// {"format": "rinceau-grammar", "version": 1, ..}: everything that the grammar's text says, comments, uses and fragments
/// included. Expressions are text in the grammar's own language, outlines SVG path data; all is y down.
/// Guarantee: parse_json_grammar gives the same grammar again, numbers exact.
Export to_json(const Grammar& grammar, const ExportOptions& options = {});

/// Does the text begin as JSON does? The text of a grammar never does.
bool looks_like_json(std::string_view text);

/// Throws InputError, with line and column where the JSON itself is at fault, else with the member's path
/// ("productions[3].condition"); LimitError for a document of more values than a grammar can have.
Grammar parse_json_grammar(std::string_view text, const std::string& file_name = {});

}  // namespace rinceau
