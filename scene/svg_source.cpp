#include "scene/svg_source.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

#include "scene/svg_number.h"
#include "scene/svg_utf8.h"

namespace rinceau {

namespace {

constexpr std::string_view utf8_mark = "\xEF\xBB\xBF";

// Decompresses and hands over block after block; false if the data are broken.
bool inflate_blocks(std::string_view bytes, const std::function<void(std::string_view)>& take) {
    constexpr int gzip_header = 16;  // zlib: MAX_WBITS + 16 expects gzip
    z_stream stream{};
    if (inflateInit2(&stream, MAX_WBITS + gzip_header) != Z_OK) return false;
    const struct End {
        z_stream& ended;
        ~End() { inflateEnd(&ended); }
    } end{stream};
    // zlib's interface is not const-correct; it only reads the input.
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream.avail_in = static_cast<uInt>(bytes.size());
    std::array<char, 1 << 16> block{};
    int state = Z_OK;
    while (state == Z_OK) {
        stream.next_out = reinterpret_cast<Bytef*>(block.data());
        stream.avail_out = static_cast<uInt>(block.size());
        state = inflate(&stream, Z_NO_FLUSH);
        take({block.data(), block.size() - stream.avail_out});
    }
    return state == Z_STREAM_END;
}

std::string decompressed(std::string_view bytes, const SvgSourceOptions& options) {
    // Count first: a bomb must not fill the memory.
    std::size_t size = 0;
    const auto count = [&](std::string_view block) {
        size += block.size();
        if (size > options.max_bytes) {
            throw LimitError({options.file_name, 1, 1}, "the decompressed text is longer than the limit of " +
                                                            std::to_string(options.max_bytes) + " bytes");
        }
    };
    if (!inflate_blocks(bytes, count)) {
        throw InputError({options.file_name, 1, 1}, "the gzip data are broken or cut off");
    }
    std::string text;
    text.reserve(size);
    inflate_blocks(bytes, [&](std::string_view block) { text += block; });
    return text;
}

// The encoding that the XML declaration names, in lower case.
std::string declared_encoding(std::string_view text) {
    if (!text.starts_with("<?xml")) return {};
    const std::string_view declaration = text.substr(0, text.find("?>"));
    const std::size_t name = declaration.find("encoding");
    if (name == std::string_view::npos) return {};
    const std::size_t open = declaration.find_first_of("\"'", name);
    if (open == std::string_view::npos) return {};
    const std::size_t close = declaration.find(declaration[open], open + 1);
    if (close == std::string_view::npos) return {};
    return lower_case(declaration.substr(open + 1, close - open - 1));
}

std::string decoded(std::string_view bytes) {
    using namespace std::string_view_literals;
    if (bytes.starts_with(utf8_mark)) return valid_utf8(bytes.substr(utf8_mark.size()));
    if (bytes.starts_with("\xFF\xFE"sv)) return utf8_from_utf16(bytes.substr(2), false);
    if (bytes.starts_with("\xFE\xFF"sv)) return utf8_from_utf16(bytes.substr(2), true);
    if (bytes.starts_with("<\0"sv)) return utf8_from_utf16(bytes, false);
    if (bytes.starts_with("\0<"sv)) return utf8_from_utf16(bytes, true);
    constexpr std::array<std::string_view, 6> western{"iso-8859-1", "iso8859-1",    "latin1",
                                                      "latin-1",    "windows-1252", "cp1252"};
    const bool is_western = std::find(western.begin(), western.end(), declared_encoding(bytes)) != western.end();
    return is_western ? utf8_from_windows_1252(bytes) : valid_utf8(bytes);
}

// What a file that is no XML may be instead.
std::string_view known_format(std::string_view bytes) {
    using namespace std::string_view_literals;
    constexpr std::array<std::pair<std::string_view, std::string_view>, 6> formats{{{"\x89PNG"sv, "a PNG picture"},
                                                                                    {"\xFF\xD8\xFF"sv, "a JPEG picture"},
                                                                                    {"GIF8"sv, "a GIF picture"},
                                                                                    {"%PDF"sv, "a PDF document"},
                                                                                    {"PK\x03\x04"sv, "a ZIP archive"},
                                                                                    {"%!PS"sv, "a PostScript file"}}};
    for (const auto& [mark, name] : formats) {
        if (bytes.starts_with(mark)) return name;
    }
    return {};
}

// An XML text starts with '<', maybe after white space, and has no NUL.
void require_xml(std::string_view bytes, const std::string& text, const std::string& file_name) {
    const std::size_t start = text.find_first_not_of(" \t\r\n");
    if (start == std::string::npos) throw InputError({file_name, 1, 1}, "the file is empty, expected an SVG document");
    if (const std::string_view format = known_format(bytes); !format.empty()) {
        throw InputError({file_name, 1, 1}, "expected an SVG document, found " + std::string(format));
    }
    if (text[start] != '<') {
        throw InputError(place_in_text(text, start, file_name), "expected an SVG document, which starts with \"<\"");
    }
}

void require_no_nul(std::string_view bytes, const std::string& file_name) {
    const bool is_utf16 =
        bytes.size() >= 2 && (bytes[0] == '\0' || bytes[1] == '\0' || bytes[0] == '\xFF' || bytes[0] == '\xFE');
    const std::size_t nul = bytes.find('\0');
    if (is_utf16 || nul == std::string_view::npos) return;
    throw InputError(place_in_text(bytes, nul, file_name), "expected an SVG document, found a NUL byte (binary data)");
}

}  // namespace

std::string svg_source_text(std::string_view bytes, const SvgSourceOptions& options) {
    // Decompress.
    using namespace std::string_view_literals;
    std::string unpacked;
    if (bytes.starts_with("\x1F\x8B"sv)) bytes = unpacked = decompressed(bytes, options);
    if (bytes.size() > options.max_bytes) {
        throw LimitError({options.file_name, 1, 1},
                         "the file is longer than the limit of " + std::to_string(options.max_bytes) + " bytes");
    }

    // Decode, and see whether this can be XML at all.
    std::string text = decoded(bytes);
    require_xml(bytes, text, options.file_name);
    require_no_nul(bytes, options.file_name);

    // Take the DOCTYPE out, its line breaks stay; put its entities in.
    const XmlDoctype doctype = find_doctype(text, options.file_name);
    if (doctype.begin == doctype.end) return text;
    const auto begin = text.begin() + static_cast<std::ptrdiff_t>(doctype.begin);
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(doctype.end);
    const auto breaks = static_cast<std::size_t>(std::count(begin, end, '\n'));
    text.replace(doctype.begin, doctype.end - doctype.begin, std::string(breaks, '\n'));
    return with_entities_expanded(text, doctype.entities, options.max_bytes, options.file_name);
}

}  // namespace rinceau
