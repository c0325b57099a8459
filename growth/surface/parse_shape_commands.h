#pragma once
// Commands of a shape grammar's text. Internal to the folder.

#include <string_view>
#include <vector>

#include "growth/surface/shape_grammar.h"
#include "lsystem/scanner.h"

namespace rinceau {

/// Commands up to one of `stops` or the end of the statement; every [ has its ]. Wrong numbers of arguments are kept as
/// mistakes by the scanner, others throw InputError.
std::vector<ShapeCommand> parse_shape_commands(Scanner& scanner, std::string_view stops);

/// An expression with queries, as far as it goes.
Expression parse_shape_expression(Scanner& scanner);

}  // namespace rinceau
