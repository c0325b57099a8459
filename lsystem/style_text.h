#pragma once
// Styles in a grammar's text: SVG's property names, y down (docs/language.md). Internal to the folder.

#include <string>

#include "lsystem/scanner.h"
#include "scene/style.h"

namespace rinceau {

/// "fill #ffcc00; stroke-width 2; .." up to the end of the statement. Throws InputError.
Style parse_style(Scanner& scanner);

/// The same text: fill always, everything else where it differs from a default Style.
std::string style_text(const Style& style);

}  // namespace rinceau
