#pragma once
// Names that another program allows, in place of the grammar's. Internal to the folder.

#include <functional>
#include <set>
#include <string>
#include <string_view>

namespace rinceau {

/// `wish` if it is allowed and not taken, else with an underscore or a number behind it; the result is taken from then on.
std::string free_name(const std::string& wish, std::set<std::string>& taken,
                      const std::function<bool(std::string_view)>& allowed);

/// Text for a comment that ends with its line: line ends become blanks.
std::string one_line(std::string_view text);

}  // namespace rinceau
