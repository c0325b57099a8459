#pragma once
// What is wrong with a shape grammar, and what is perhaps not meant.

#include <string>
#include <string_view>

#include "growth/surface/shape_expressions.h"
#include "growth/surface/shape_sources.h"
#include "lsystem/grammar_text.h"

namespace rinceau {

/// Every mistake in a shape grammar's text by its place: syntax; unknown symbols, shapes, fields, queries, names, kinds and
/// options; wrong numbers of arguments; shapes that cannot be made; files that cannot be read. Hints, only without mistakes:
/// params, shapes and rules that nothing uses, symbols that nothing ends. Files are read by the names that the grammar gives
/// them; without `read_file` they are not looked at.
GrammarFindings inspect_shape_grammar(std::string_view text, const std::string& file_name = {},
                                      const ReadNamedFile& read_file = {});

/// The same mistakes of a grammar whose text has none of syntax, by their place.
std::vector<Warning> shape_grammar_mistakes(const ShapeGrammar& grammar, const ReadNamedFile& read_file = {});

}  // namespace rinceau
