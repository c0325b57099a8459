#pragma once
// Exact things that were placed by hand (docs/analysis.md, 4.8): what a drawing's rules leave in the axiom is given the
// places that it was meant to have, so that rules for it are searched for there.

#include <optional>

#include "analyzer/description.h"
#include "analyzer/generate_rules.h"

namespace rinceau {

/// The rules of `exact` and more for what its axiom lists, which stands regularly up to the irregularity of a hand: the
/// exceptions say where it is drawn. Nothing if no part stands four times in an arrangement without being regular already,
/// or if no rule is found for what does.
std::optional<Description> with_regular_roots(const Description& exact, const SearchOptions& search,
                                              const Progress& progress);

}  // namespace rinceau
