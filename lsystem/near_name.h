#pragma once
// The name that was meant: for messages about a name that does not exist.

#include <string>
#include <vector>

namespace rinceau {

/// The one of `known` that takes the fewest letters to be changed, added or left out to become `name` (upper and lower case
/// count as equal); empty if that are more than a third of them.
std::string nearest_name(const std::string& name, const std::vector<std::string>& known);

/// ": did you mean 'Window'?", or, if nothing is near, ": it has A, B, C and 4 more"; empty for no known names.
std::string instead_of(const std::string& name, const std::vector<std::string>& known);

}  // namespace rinceau
