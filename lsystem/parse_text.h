#pragma once
// A grammar's text as a grammar and its mistakes. Internal to the folder.

#include <string>
#include <string_view>

#include "lsystem/parse_statement.h"

namespace rinceau {

/// What could be read. The mistakes are in order of place; the grammar is the text's if there is none.
ParseState parse_text(std::string_view text, const std::string& file_name);

}  // namespace rinceau
