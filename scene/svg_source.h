#pragma once
// From the bytes of a file to clean XML text: decompression, character encoding, entities.

#include <cstddef>
#include <string>
#include <string_view>

#include "scene/input_error.h"
#include "scene/svg_entities.h"

namespace rinceau {

struct SvgSourceOptions {
    std::string file_name;               ///< for messages
    std::size_t max_bytes = 512u << 20;  ///< of text after decompression and expansion of entities
    int max_depth = 4096;                ///< nesting of elements
};

/// UTF-8 text without byte order mark and DOCTYPE, own entities expanded (predefined ones and character references are left
/// to the XML library), invalid bytes replaced by U+FFFD, lines numbered as in the (decompressed) input.
/// Reads gzip, UTF-8, UTF-16 of either order, Latin-1 and Windows-1252 by the XML declaration; never opens a file.
/// Throws InputError if this is no XML text at all (empty, binary, a PNG, ...), LimitError for a size beyond the options,
/// both with line and column. Time and memory stay in proportion to the input and max_bytes.
std::string svg_source_text(std::string_view bytes, const SvgSourceOptions& options = {});

}  // namespace rinceau
