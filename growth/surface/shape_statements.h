#pragma once
// The lines of a shape grammar's text as statements. Internal to the folder.

#include <string>
#include <string_view>

#include "lsystem/statement.h"

namespace rinceau {

/// "~" or the arrow that the paper prints.
inline constexpr std::string_view rule_sign = "~";
inline constexpr std::string_view rule_arrow = "\xE2\x86\x92";

/// A statement is a line, and the lines below it while a bracket is open; a line that begins a statement of its own (a
/// keyword, or with a '~' in it) ends it, too, and the bracket is a fault. Comments run from # to the end of the line; they
/// are blanks in the statements' texts, so that places in these are places in the file. A '#' within quotation marks is
/// none.
StatementList split_shape_statements(std::string_view text, const std::string& file_name);

}  // namespace rinceau
