#pragma once
// Numbers with commas between them, on the command line.

#include <string>
#include <utility>
#include <vector>

namespace rinceau {

/// "300,200": plain decimal numbers, at least one. Throws CLI::ValidationError in the name of `option`, saying what was
/// `expected`, "two lengths, W,H".
std::vector<double> parse_numbers(const std::string& option, const std::string& expected, const std::string& text);

/// "A=2,B=1": names, each once, with numbers not below 0. Throws in the same way.
std::vector<std::pair<std::string, double>> parse_named_numbers(const std::string& option, const std::string& text);

}  // namespace rinceau
