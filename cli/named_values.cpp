#include "cli/named_values.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <CLI/Error.hpp>

#include "scene/svg_number.h"

namespace rinceau {
namespace {

[[noreturn]] void fail(const std::string& option, const std::string& expected, std::string_view found) {
    throw CLI::ValidationError(option, "expected " + expected + ", found '" + std::string(found) + "'");
}

/// "a=.., b=.. or c=.."
std::string names_expected(const std::vector<std::string>& names) {
    if (names.empty()) return "NAME=VALUE";
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i > 0) text += i + 1 < names.size() ? ", " : " or ";
        text += names[i] + "=..";
    }
    return text;
}

}  // namespace

double parse_number(const std::string& option, const std::string& what, std::string_view text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = error == std::errc{} && end == text.data() + text.size() && std::isfinite(value);
    if (!whole) fail(option, what, text);
    return value;
}

std::vector<std::string> parse_list(const std::string& option, const std::string& text) {
    std::vector<std::string> parts;
    std::size_t first = 0;
    while (true) {
        const std::size_t end = std::min(text.find(',', first), text.size());
        parts.push_back(text.substr(first, end - first));
        if (parts.back().empty()) fail(option, "a list like A,B", text);
        if (end == text.size()) return parts;
        first = end + 1;
    }
}

std::vector<std::pair<std::string, double>> parse_named_values(const NamedValues& format, const std::string& text) {
    std::vector<std::pair<std::string, double>> values;
    for (const std::string& part : parse_list(format.option, text)) {
        const std::string name = part.substr(0, part.find('='));
        const bool known = format.names.empty() || std::ranges::find(format.names, name) != format.names.end();
        if (name.empty() || name.size() == part.size() || !known) fail(format.option, names_expected(format.names), part);
        const auto same = [&name](const auto& value) { return value.first == name; };
        if (std::ranges::any_of(values, same)) fail(format.option, "each name once", part);
        const std::string range =
            "a number from " + svg_number(format.low) + " to " + svg_number(format.high) + " after '='";
        const std::string_view number = std::string_view(part).substr(name.size() + 1);
        double value = 0;
        const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
        const bool whole = error == std::errc{} && end == number.data() + number.size();
        if (!whole || !(value >= format.low && value <= format.high)) fail(format.option, range, part);
        values.emplace_back(name, value);
    }
    return values;
}

}  // namespace rinceau
