#pragma once
// Numbers in SVG and CSS text: reading them off the front of a text, writing them.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rinceau {

/// A place in a text that moves forward as things are read. Every function leaves it unmoved if it finds nothing.
struct TextCursor {
    std::string_view text;
    std::size_t at = 0;

    bool at_end() const { return at >= text.size(); }
    char peek() const { return at_end() ? '\0' : text[at]; }
};

/// Space, tab, line feed, form feed, carriage return.
constexpr bool is_svg_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\f' || c == '\r'; }
std::string_view trimmed(std::string_view text);
/// ASCII lower case.
std::string lower_case(std::string_view text);

void skip_space(TextCursor& cursor);
/// Skips white space with at most one comma in it; true if there was a comma.
bool skip_comma_space(TextCursor& cursor);
/// Skips `token` if it comes next (exact case).
bool skip_token(TextCursor& cursor, std::string_view token);
/// A number by SVG's grammar ("-.5", "1.", "+3e-2"); nothing for anything else, for a number too large for double.
/// "1e" and "1em" are the number 1: the exponent needs digits. A fault is left at the cursor.
std::optional<double> read_number(TextCursor& cursor);
/// Numbers separated by white space and commas, to the end of the text; nothing if anything else occurs.
std::optional<std::vector<double>> parse_numbers(std::string_view text);

/// The shortest text that reads back as the same double (digits = 0), or one of at most `digits` significant digits.
/// No "-0", no trailing zeros, a digit before the point. `value` must be finite.
std::string svg_number(double value, int digits = 0);

}  // namespace rinceau
