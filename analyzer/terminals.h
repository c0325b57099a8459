#pragma once
// Looks as terminals of a grammar, with numbered styles.

#include <string>
#include <vector>

#include "analyzer/instancing.h"
#include "lsystem/grammar.h"

namespace rinceau {

/// "A" .. "Z", then "A1" .. "Z1", "A2" .. , without P, the letter of productions.
std::string terminal_name(int index);

/// Adds a terminal for each look (in the order of `looks`, named by that order) and the styles that they need, equal ones
/// once. anchors[look]: terminal frame -> unit frame. Coordinates are rounded to `slack` (terminal units).
void add_terminals(Grammar& grammar, const Instancing& instancing, const Scene& scene, const std::vector<int>& looks,
                   const std::vector<Similarity>& anchors, double slack);

}  // namespace rinceau
