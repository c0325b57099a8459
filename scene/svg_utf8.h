#pragma once
// Characters as UTF-8.

#include <cstdint>
#include <string>
#include <string_view>

namespace rinceau {

/// A code point as UTF-8; U+FFFD for what is no character of XML (0, surrogates, beyond 10FFFF, control characters).
std::string utf8_of(std::uint32_t code);

/// The text with bytes that are no UTF-8, and characters that XML does not allow, replaced by U+FFFD.
std::string valid_utf8(std::string_view text);

/// UTF-16 as UTF-8; a lone surrogate and an odd last byte become U+FFFD.
std::string utf8_from_utf16(std::string_view bytes, bool big_endian);

/// Windows-1252 as UTF-8; Latin-1 is the same but for its unused control codes.
std::string utf8_from_windows_1252(std::string_view bytes);

}  // namespace rinceau
