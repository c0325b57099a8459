#include "scene/svg_css_text.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "scene/svg_utf8.h"

namespace rinceau {

namespace {

constexpr std::string_view important_mark = "important";

bool is_name_start(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '\\' ||
           static_cast<unsigned char>(c) >= 0x80;
}
bool is_name_char(char c) { return is_name_start(c) || (c >= '0' && c <= '9') || c == '-'; }

int hex_value(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

// The character of an escape; the cursor stands behind the backslash.
std::string read_escape(TextCursor& cursor) {
    constexpr int most_digits = 6;
    std::uint32_t code = 0;
    int digits = 0;
    for (; digits < most_digits && hex_value(cursor.peek()) >= 0; ++digits) {
        code = code * 16 + static_cast<std::uint32_t>(hex_value(cursor.text[cursor.at++]));
    }
    if (digits == 0) return cursor.at_end() ? std::string() : std::string(1, cursor.text[cursor.at++]);
    if (is_svg_space(cursor.peek())) ++cursor.at;
    return utf8_of(code);
}

// Splits "value ! important" at its mark.
std::pair<std::string_view, bool> without_important(std::string_view value) {
    if (value.size() <= important_mark.size()) return {value, false};
    const std::size_t at = value.size() - important_mark.size();
    if (lower_case(value.substr(at)) != important_mark) return {value, false};
    const std::string_view before = trimmed(value.substr(0, at));
    if (before.empty() || before.back() != '!') return {value, false};
    return {trimmed(before.substr(0, before.size() - 1)), true};
}

}  // namespace

std::string without_css_comments(std::string_view text) {
    constexpr std::array<std::string_view, 4> marks{"<!--", "-->", "<![CDATA[", "]]>"};
    std::string result;
    result.reserve(text.size());
    for (std::size_t at = 0; at < text.size();) {
        const std::string_view rest = text.substr(at);
        if (rest.starts_with("/*")) {
            const std::size_t end = text.find("*/", at + 2);
            at = end == std::string_view::npos ? text.size() : end + 2;
            result += ' ';
            continue;
        }
        const auto mark = std::find_if(marks.begin(), marks.end(), [&](std::string_view m) { return rest.starts_with(m); });
        if (mark != marks.end()) {
            at += mark->size();
            result += ' ';
            continue;
        }
        result += text[at++];
    }
    return result;
}

std::size_t find_css_end(std::string_view text, std::size_t from, std::string_view ends) {
    int depth = 0;
    char quote = '\0';
    for (std::size_t at = from; at < text.size(); ++at) {
        const char c = text[at];
        if (c == '\\') {
            ++at;
        } else if (quote != '\0') {
            if (c == quote) quote = '\0';
        } else if (depth == 0 && ends.find(c) != std::string_view::npos) {
            return at;
        } else if (c == '"' || c == '\'') {
            quote = c;
        } else if (c == '(' || c == '[' || c == '{') {
            ++depth;
        } else if ((c == ')' || c == ']' || c == '}') && depth > 0) {
            --depth;
        }
    }
    return text.size();
}

std::optional<std::string> read_css_identifier(TextCursor& cursor) {
    TextCursor look = cursor;
    while (look.peek() == '-') ++look.at;
    if (look.at_end() || !is_name_start(look.peek())) return std::nullopt;
    std::string name(cursor.text.substr(cursor.at, look.at - cursor.at));
    while (!look.at_end() && is_name_char(look.peek())) {
        const char c = look.text[look.at++];
        if (c == '\\') {
            name += read_escape(look);
        } else {
            name += c;
        }
    }
    cursor = look;
    return name;
}

std::optional<std::string> read_css_string(TextCursor& cursor) {
    const char quote = cursor.peek();
    if (quote != '"' && quote != '\'') return std::nullopt;
    TextCursor look{cursor.text, cursor.at + 1};
    std::string value;
    while (!look.at_end()) {
        const char c = look.text[look.at++];
        if (c == quote) {
            cursor = look;
            return value;
        }
        if (c == '\\') {
            value += read_escape(look);
        } else {
            value += c;
        }
    }
    return std::nullopt;
}

std::vector<CssDeclaration> parse_declarations(std::string_view text) {
    std::string cleaned;
    if (text.find("/*") != std::string_view::npos) text = cleaned = without_css_comments(text);
    std::vector<CssDeclaration> declarations;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = find_css_end(text, at, ";");
        const std::string_view declaration = text.substr(at, end - at);
        at = end + 1;
        const std::size_t colon = declaration.find(':');
        if (colon == std::string_view::npos) continue;
        const std::string_view property = trimmed(declaration.substr(0, colon));
        const auto [value, important] = without_important(trimmed(declaration.substr(colon + 1)));
        const bool is_name = !property.empty() && std::all_of(property.begin(), property.end(), is_name_char);
        if (is_name && !value.empty()) declarations.push_back({lower_case(property), std::string(value), important});
    }
    return declarations;
}

}  // namespace rinceau
