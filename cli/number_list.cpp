#include "cli/number_list.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include <CLI/Error.hpp>

namespace rinceau {
namespace {

[[noreturn]] void fail(const std::string& option, const std::string& expected, std::string_view found) {
    throw CLI::ValidationError(option, "expected " + expected + ", found '" + std::string(found) + "'");
}

std::vector<std::string_view> split(std::string_view text) {
    std::vector<std::string_view> parts;
    while (true) {
        parts.push_back(text.substr(0, text.find(',')));
        if (parts.back().size() == text.size()) return parts;
        text.remove_prefix(parts.back().size() + 1);
    }
}

bool reads_number(std::string_view text, double& value) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc{} && end == text.data() + text.size() && std::isfinite(value);
}

}  // namespace

std::vector<double> parse_numbers(const std::string& option, const std::string& expected, const std::string& text) {
    std::vector<double> numbers;
    for (const std::string_view part : split(text))
        if (!reads_number(part, numbers.emplace_back())) fail(option, expected, text);
    return numbers;
}

std::vector<std::pair<std::string, double>> parse_named_numbers(const std::string& option, const std::string& text) {
    std::vector<std::pair<std::string, double>> numbers;
    for (const std::string_view part : split(text)) {
        const std::string name(part.substr(0, part.find('=')));
        double value = 0;
        if (name.empty() || name.size() == part.size() || !reads_number(part.substr(name.size() + 1), value) || value < 0)
            fail(option, "SYMBOL=NUMBER with commas between them", part);
        if (std::ranges::count(numbers, name, &std::pair<std::string, double>::first) > 0) fail(option, "each symbol once", part);
        numbers.emplace_back(name, value);
    }
    return numbers;
}

}  // namespace rinceau
