#pragma once
// The surface of CSS text: comments, strings, brackets, names, declarations.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/svg_number.h"

namespace rinceau {

struct CssDeclaration {
    std::string property;  ///< lower case
    std::string value;     ///< trimmed, comments removed, without "!important"
    bool important = false;
};

/// "fill:red; stroke : blue !important": what is not a declaration is skipped.
std::vector<CssDeclaration> parse_declarations(std::string_view text);

/// The text with comments and the marks <!-- --> <![CDATA[ ]]> replaced by a space each.
std::string without_css_comments(std::string_view text);

/// Offset of the first of `ends` that stands outside of strings and of ( ) [ ] { } opened after `from`; the text's size if
/// there is none.
std::size_t find_css_end(std::string_view text, std::size_t from, std::string_view ends);

/// An identifier, escapes resolved; nothing if none starts here.
std::optional<std::string> read_css_identifier(TextCursor& cursor);
/// A quoted string, escapes resolved; nothing if none starts here or it does not end.
std::optional<std::string> read_css_string(TextCursor& cursor);

}  // namespace rinceau
