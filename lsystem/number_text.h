#pragma once
// Numbers and names as text. Internal to lsystem and growth.

#include <string>
#include <string_view>

namespace rinceau {

/// Shortest text that reads back as the same number; zero has no sign.
std::string number_text(double value);
void append_number(std::string& text, double value);

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
constexpr bool starts_name(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
constexpr bool continues_name(char c) { return starts_name(c) || is_digit(c); }
constexpr bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

/// A letter or underscore, then letters, digits and underscores.
bool is_name(std::string_view text);

}  // namespace rinceau
