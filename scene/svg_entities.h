#pragma once
// The DOCTYPE of an XML text and the entities that it declares (XML 1.0, sections 2.8, 4.2 to 4.4).

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

#include "scene/input_error.h"

namespace rinceau {

/// Name -> text of internal general entities; external and parameter entities are left out and never read.
using XmlEntities = std::map<std::string, std::string, std::less<>>;

struct XmlDoctype {
    std::size_t begin = 0, end = 0;  ///< offsets of the declaration; equal if there is none
    XmlEntities entities;
};

/// Throws InputError if the declaration does not end.
XmlDoctype find_doctype(std::string_view text, const std::string& file_name);

/// The text with references to `entities` replaced, again and again, in character data and in attribute values; references
/// to anything else are left alone. Lines stay where they are.
/// Throws LimitError if entities nest too deep or refer to themselves, or if the result would exceed `max_bytes` or grow
/// by more than 64 MiB: found before anything is expanded.
std::string with_entities_expanded(std::string_view text, const XmlEntities& entities, std::size_t max_bytes,
                                   const std::string& file_name);

/// Line and column (from 1, columns in characters) of an offset in a UTF-8 text.
SourcePlace place_in_text(std::string_view text, std::size_t offset, const std::string& file_name);

}  // namespace rinceau
