#pragma once
// Writing numbers into a grammar. Internal to the folder.

#include <string>
#include <vector>

#include "lsystem/numbers.h"

namespace rinceau {

/// The same number without the last digits that arithmetic leaves: 3.3 for 3 * 1.1.
double rounded(double value);

/// For a person to read: six digits.
std::string short_text(double value);

/// The grammar with slope * value + offset in the slot. A turn below 0 becomes one to the other side.
Grammar with_slot(Grammar grammar, const NumberSlot& slot, const Expression& value);

/// The name of the number that is written there: the first of the least rank; empty if none is.
std::string name_of_place(const std::vector<GrammarNumber>& numbers, const ExpressionPlace& place);

}  // namespace rinceau
