#pragma once
// What all targets for libFuzzer have in common: an input may be refused, by an InputError or a LimitError; whatever else is
// thrown, every broken promise and every finding of a sanitizer ends the program with the input kept.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "scene/input_error.h"

namespace rinceau {

/// Takes an input to pieces. Bounded in time and memory.
void take_input(std::string_view bytes);

/// What a header promises of any input; `promise` says it in a few words.
inline void require(bool kept, const char* promise) {
    if (kept) return;
    std::fprintf(stderr, "ERROR: not kept: %s\n", promise);
    std::abort();
}

/// Runs `read`; was the input taken rather than refused?
template <class Read>
bool is_taken(const Read& read) {
    try {
        read();
    } catch (const InputError&) {
        return false;
    } catch (const LimitError&) {
        return false;
    }
    return true;
}

}  // namespace rinceau

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    rinceau::is_taken([&] { rinceau::take_input({reinterpret_cast<const char*>(data), size}); });
    return 0;
}
