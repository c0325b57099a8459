#pragma once
// What takes the place of a symbol, as a person writes it.

#include <string>

#include "lsystem/edit_replace.h"

namespace rinceau {

/// "SYMBOL=WITH", where WITH is modules ("Leaf", "Ring(8)"), a drawing ("leaf.svg"), a grammar ("vine.lsys") or a part of
/// one
/// ("vine.lsys#Grapes"), or nothing. Reads the file. Says the warnings of a drawing. Throws CLI::ValidationError, and as
/// read_input(), read_svg() and read_grammar().
Replacement parse_replacement(const std::string& text);

}  // namespace rinceau
