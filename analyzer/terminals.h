#pragma once
// Looks as terminals of a grammar, with numbered styles.

#include <string>
#include <vector>

#include "analyzer/instancing.h"
#include "lsystem/grammar.h"

namespace rinceau {

/// The style of a look as its terminal has it: anchor = terminal frame -> unit frame. Lengths have six digits.
Style terminal_style(const Style& unit_style, const Similarity& anchor);

/// The number of the style in `styles`; added to them, with the next number, if none is equal.
int style_number(std::vector<NumberedStyle>& styles, const Style& style);

/// Adds a terminal for each look (in the order of `looks`) and the styles that they need, equal ones once. names[look]: its
/// symbol; anchors[look]: terminal frame -> unit frame. Coordinates are rounded to `slack` (terminal units).
void add_terminals(Grammar& grammar, const Instancing& instancing, const Scene& scene, const std::vector<int>& looks,
                   const std::vector<std::string>& names, const std::vector<Similarity>& anchors, double slack);

}  // namespace rinceau
