#pragma once
// The text of a field-guided shape grammar, .fgsg (docs/shape_grammars.md).

#include <string>
#include <string_view>
#include <vector>

#include "growth/surface/shape_grammar.h"

namespace rinceau {

/// Throws InputError (file, line, column, what was expected, what was found) at the first mistake of form. Whether what it
/// names is there is for check_shape_grammar().
ShapeGrammar parse_shape_grammar(std::string_view text, const std::string& file_name = {});

struct ParsedShapeGrammar {
    ShapeGrammar grammar;           ///< of the statements without mistakes
    std::vector<Warning> mistakes;  ///< by place, at most some 1000
};

/// Reads on behind mistakes.
ParsedShapeGrammar read_shape_grammar(std::string_view text, const std::string& file_name = {});

/// Is this the text of a shape grammar and not of an L-system? By its first statement.
bool looks_like_shape_grammar(std::string_view text);

}  // namespace rinceau
