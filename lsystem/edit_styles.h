#pragma once
// Other paints for terminals.

#include <string>
#include <vector>

#include "lsystem/edit_result.h"
#include "lsystem/grammar.h"

namespace rinceau {

/// The terminals of the grammar that are painted in the same style as `symbol`, itself among them. Empty if it is not a
/// terminal of the grammar with outlines.
std::vector<std::string> sharing_style(const Grammar& grammar, const std::string& symbol);

enum class RestyleWhat : unsigned char { only_this, all_that_share };

/// The terminal in another style, alone or with all that share its old one: alone it gets a style of its own, with a number
/// that is free, if something else is painted in the old one. Styles that strings choose by ;(n) are left as they are, but
/// for `all_that_share`. Throws InputError for a symbol that is not a terminal with outlines of the grammar itself.
EditResult restyle_terminal(const Grammar& grammar, const std::string& symbol, const Style& style, RestyleWhat what);

}  // namespace rinceau
