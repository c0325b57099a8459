#pragma once
// What all targets for libFuzzer have in common: an input may be refused, by an InputError or a LimitError; whatever else is
// thrown, and every finding of a sanitizer, ends the program with the input kept.

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "scene/input_error.h"

namespace rinceau {

/// Takes an input to pieces. Bounded in time and memory.
void take_input(std::string_view bytes);

}  // namespace rinceau

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        rinceau::take_input({reinterpret_cast<const char*>(data), size});
    } catch (const rinceau::InputError&) {
    } catch (const rinceau::LimitError&) {
    }
    return 0;
}
