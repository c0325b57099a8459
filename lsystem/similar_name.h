#pragma once
// Which known name an unknown one was perhaps meant to be.

#include <string>
#include <string_view>
#include <vector>

namespace rinceau {

/// Letters that are missing, too many, others or exchanged with their neighbour, upper and lower case being the same; more
/// than `most` count as most + 1.
int edit_distance(std::string_view a, std::string_view b, int most);

/// The first of the names that differ least from `name`: in at most one letter of a short name (up to four letters), in two
/// of a longer one. Empty if there is none, or if `name` is a single letter that differs in more than its case.
std::string_view similar_name(std::string_view name, const std::vector<std::string_view>& names);

/// " (did you mean 'Window'?)", or nothing.
std::string did_you_mean(std::string_view name, const std::vector<std::string_view>& names);

/// ": did you mean 'Window'?", or, if nothing is like it, ": there is A, B, C and 4 more"; empty for no known names.
std::string instead_of(std::string_view name, const std::vector<std::string>& known);

}  // namespace rinceau
