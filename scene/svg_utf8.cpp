#include "scene/svg_utf8.h"

#include <array>
#include <cstddef>

namespace rinceau {

namespace {

constexpr std::uint32_t replacement = 0xFFFD;
constexpr std::uint32_t last_code = 0x10FFFF;

bool is_xml_character(std::uint32_t code) {
    if (code < 0x20) return code == '\t' || code == '\n' || code == '\r';
    return code <= last_code && !(code >= 0xD800 && code <= 0xDFFF) && code != 0xFFFE && code != 0xFFFF;
}

// Bytes 0x80 to 0x9F; the five unused ones are replaced.
constexpr std::array<std::uint16_t, 32> windows_1252{0x20AC, 0xFFFD, 0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021,
                                                     0x02C6, 0x2030, 0x0160, 0x2039, 0x0152, 0xFFFD, 0x017D, 0xFFFD,
                                                     0xFFFD, 0x2018, 0x2019, 0x201C, 0x201D, 0x2022, 0x2013, 0x2014,
                                                     0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0xFFFD, 0x017E, 0x0178};

std::uint32_t byte_at(std::string_view text, std::size_t at) { return static_cast<unsigned char>(text[at]); }

struct Decoded {
    std::uint32_t code = replacement;
    std::size_t size = 1;  // bytes read
};

// One character of UTF-8; over-long forms are faults.
Decoded decode(std::string_view text, std::size_t at) {
    const std::uint32_t lead = byte_at(text, at);
    if (lead < 0x80) return {lead, 1};
    const std::size_t size = lead >= 0xF0 && lead < 0xF8   ? 4
                             : lead >= 0xE0 && lead < 0xF0 ? 3
                             : lead >= 0xC0 && lead < 0xE0 ? 2
                                                           : 0;
    if (size == 0 || at + size > text.size()) return {};
    constexpr std::array<std::uint32_t, 5> least{0, 0, 0x80, 0x800, 0x10000};
    std::uint32_t code = lead & (0xFFu >> (size + 1));
    for (std::size_t i = 1; i < size; ++i) {
        const std::uint32_t next = byte_at(text, at + i);
        if ((next & 0xC0) != 0x80) return {};
        code = code << 6 | (next & 0x3F);
    }
    return code >= least[size] ? Decoded{code, size} : Decoded{};
}

}  // namespace

std::string utf8_of(std::uint32_t code) {
    if (!is_xml_character(code)) code = replacement;
    const auto byte = [](std::uint32_t value) { return static_cast<char>(value); };
    const auto tail = [&](int shift) { return byte(0x80 | (code >> shift & 0x3F)); };
    if (code < 0x80) return {byte(code)};
    if (code < 0x800) return {byte(0xC0 | code >> 6), tail(0)};
    if (code < 0x10000) return {byte(0xE0 | code >> 12), tail(6), tail(0)};
    return {byte(0xF0 | code >> 18), tail(12), tail(6), tail(0)};
}

std::string valid_utf8(std::string_view text) {
    std::string result;
    result.reserve(text.size());
    for (std::size_t at = 0; at < text.size();) {
        // Most of a drawing is plain ASCII: take it in one piece.
        std::size_t plain_end = at;
        while (plain_end < text.size() && byte_at(text, plain_end) >= ' ' && byte_at(text, plain_end) < 0x80) ++plain_end;
        result += text.substr(at, plain_end - at);
        at = plain_end;
        if (at == text.size()) break;
        const Decoded decoded = decode(text, at);
        // A fault decodes as the replacement character, whatever the bytes.
        if (decoded.code == replacement || !is_xml_character(decoded.code)) {
            result += utf8_of(replacement);
        } else {
            result += text.substr(at, decoded.size);
        }
        at += decoded.size;
    }
    return result;
}

std::string utf8_from_utf16(std::string_view bytes, bool big_endian) {
    const auto unit = [&](std::size_t at) {
        return big_endian ? byte_at(bytes, at) << 8 | byte_at(bytes, at + 1)
                          : byte_at(bytes, at + 1) << 8 | byte_at(bytes, at);
    };
    std::string result;
    result.reserve(bytes.size());
    std::size_t at = 0;
    while (at + 1 < bytes.size()) {
        std::uint32_t code = unit(at);
        at += 2;
        const bool leads = code >= 0xD800 && code < 0xDC00 && at + 1 < bytes.size();
        if (leads && unit(at) >= 0xDC00 && unit(at) < 0xE000) {
            code = 0x10000 + ((code - 0xD800) << 10) + (unit(at) - 0xDC00);
            at += 2;
        }
        result += utf8_of(code);
    }
    if (at < bytes.size()) result += utf8_of(replacement);
    return result;
}

std::string utf8_from_windows_1252(std::string_view bytes) {
    std::string result;
    result.reserve(bytes.size());
    for (std::size_t at = 0; at < bytes.size(); ++at) {
        const std::uint32_t byte = byte_at(bytes, at);
        result += utf8_of(byte >= 0x80 && byte < 0xA0 ? windows_1252[byte - 0x80] : byte);
    }
    return result;
}

}  // namespace rinceau
