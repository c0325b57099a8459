#include "cli/number_range.h"

#include <charconv>
#include <sstream>
#include <string>

namespace rinceau {

CLI::Validator number_between(double low, double high) {
    std::ostringstream range;
    range << "from " << low << " to " << high;
    const auto fault = [low, high, text = range.str()](const std::string& word) -> std::string {
        double value = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        const bool whole = error == std::errc{} && end == word.data() + word.size();
        return whole && value >= low && value <= high ? "" : "expected a number " + text + ", found '" + word + "'";
    };
    return {fault, "", "number"};
}

}  // namespace rinceau
