#pragma once
// Lists of names with numbers on the command line: "angle=10,scale=0.2".

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rinceau {

struct NamedValues {
    std::string option;              ///< "--jitter"
    std::vector<std::string> names;  ///< that are known; empty = any
    double low = 0, high = 1;        ///< of the values
};

/// In the order given. Throws CLI::ValidationError naming the option and the part at fault: an unknown or repeated name, or
/// a value that is no number in the range.
std::vector<std::pair<std::string, double>> parse_named_values(const NamedValues& format, const std::string& text);

/// The parts between commas, none of them empty. Throws CLI::ValidationError naming the option.
std::vector<std::string> parse_list(const std::string& option, const std::string& text);

/// A plain decimal number and nothing else. Throws CLI::ValidationError: "expected WHAT, found 'TEXT'".
double parse_number(const std::string& option, const std::string& what, std::string_view text);

}  // namespace rinceau
