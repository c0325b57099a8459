#include "files/fingerprint.h"

namespace rinceau {

std::uint64_t fingerprint(std::string_view bytes) {
    constexpr std::uint64_t offset_basis = 0xcbf29ce484222325U;
    constexpr std::uint64_t prime = 0x100000001b3U;
    std::uint64_t hash = offset_basis;
    for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * prime;
    return hash;
}

}  // namespace rinceau
