#include "scene/svg_number.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>

namespace rinceau {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::size_t digits_end(std::string_view text, std::size_t at) {
    while (at < text.size() && is_digit(text[at])) ++at;
    return at;
}

// The end of the number that starts at `at` (behind its sign), or `at` if there is none.
std::size_t unsigned_number_end(std::string_view text, std::size_t at) {
    const std::size_t whole_end = digits_end(text, at);
    std::size_t end = whole_end;
    if (end < text.size() && text[end] == '.') {
        const std::size_t fraction_end = digits_end(text, end + 1);
        if (fraction_end == end + 1 && whole_end == at) return at;
        end = fraction_end;
    }
    if (end == at || end >= text.size() || (text[end] != 'e' && text[end] != 'E')) return end;
    const std::size_t sign = end + 1 < text.size() && (text[end + 1] == '-' || text[end + 1] == '+') ? 1 : 0;
    const std::size_t exponent_end = digits_end(text, end + 1 + sign);
    return exponent_end > end + 1 + sign ? exponent_end : end;
}

// A number whose size no double holds: is it too small (then it is 0) rather than too large?
bool underflows(std::string_view number) {
    const std::size_t exponent = number.find_first_of("eE");
    if (exponent != std::string_view::npos) return number[exponent + 1] == '-';
    return number.front() == '0' || number.front() == '.';
}

}  // namespace

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && is_svg_space(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_svg_space(text.back())) text.remove_suffix(1);
    return text;
}

std::string lower_case(std::string_view text) {
    std::string lower(text);
    for (char& c : lower) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return lower;
}

void skip_space(TextCursor& cursor) {
    while (!cursor.at_end() && is_svg_space(cursor.peek())) ++cursor.at;
}

bool skip_comma_space(TextCursor& cursor) {
    skip_space(cursor);
    const bool comma = skip_token(cursor, ",");
    if (comma) skip_space(cursor);
    return comma;
}

bool skip_token(TextCursor& cursor, std::string_view token) {
    if (cursor.text.substr(std::min(cursor.at, cursor.text.size()), token.size()) != token) return false;
    cursor.at += token.size();
    return true;
}

std::optional<double> read_number(TextCursor& cursor) {
    const std::string_view text = cursor.text;
    const bool negative = cursor.peek() == '-';
    const std::size_t start = cursor.at + (negative || cursor.peek() == '+' ? 1 : 0);
    const std::size_t end = unsigned_number_end(text, start);
    if (end == start) return std::nullopt;
    double value = 0;
    const auto result = std::from_chars(text.data() + start, text.data() + end, value);
    if (result.ec == std::errc::result_out_of_range) {
        if (!underflows(text.substr(start, end - start))) return std::nullopt;
        value = 0;
    }
    cursor.at = end;
    return negative ? -value : value;
}

std::optional<std::vector<double>> parse_numbers(std::string_view text) {
    TextCursor cursor{trimmed(text)};
    std::vector<double> numbers;
    while (!cursor.at_end()) {
        const std::optional<double> number = read_number(cursor);
        if (!number) return std::nullopt;
        numbers.push_back(*number);
        if (skip_comma_space(cursor) && cursor.at_end()) return std::nullopt;
    }
    return numbers;
}

std::string svg_number(double value, int digits) {
    assert(std::isfinite(value));
    if (value == 0) return "0";
    std::array<char, 32> buffer{};
    const auto result = digits > 0 ? std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                                   std::chars_format::general, std::min(digits, 17))
                                   : std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return {buffer.data(), result.ptr};
}

}  // namespace rinceau
