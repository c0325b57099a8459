#pragma once
// Rings: bodies that stand evenly on circles about one centre and turn with it.

#include "analyzer/arrangement.h"

namespace rinceau {

/// Rings about the middle of the chosen bodies that hold all of them, the innermost first, or nothing.
std::vector<Arrangement> arrange_in_rings(std::span<const Body> bodies, std::span<const int> chosen, const BodyForm& form,
                                          const ArrangementScale& scale);

}  // namespace rinceau
