#pragma once
// A short number that tells texts apart.

#include <cstdint>
#include <string_view>

namespace rinceau {

/// FNV-1a of 64 bits: the same on every machine. Tells an old content from a new one; no defence against forgery.
std::uint64_t fingerprint(std::string_view bytes);

}  // namespace rinceau
