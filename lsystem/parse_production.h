#pragma once
// A production of a grammar's text. Internal to the folder.

#include <optional>
#include <string_view>

#include "lsystem/grammar.h"
#include "lsystem/scanner.h"

namespace rinceau {

constexpr std::string_view decomposition_word = "decomposition";
constexpr std::string_view homomorphism_word = "homomorphism";

/// [decomposition | homomorphism] [left <] symbol(parameters) [> right] [: condition] -> modules [: weight].
/// Nothing, if what stands before the successor could not be read; such mistakes are kept by the scanner.
/// Throws InputError.
std::optional<Production> parse_production(Scanner& scanner);

}  // namespace rinceau
