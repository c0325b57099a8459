#pragma once
// What the program says on standard error.

#include <string>
#include <string_view>
#include <vector>

#include "scene/input_error.h"

namespace rinceau {

/// One line.
void say(const std::string& line);

/// A line with its end.
constexpr std::string_view memory_does_not_suffice =
    "rinceau: the memory does not suffice; allow it more (ulimit -v), or give it less to do\n";

/// Says so without needing any.
void say_memory_does_not_suffice() noexcept;

/// "warning: file:line:column: message", a line each.
void say_warnings(const std::vector<Warning>& warnings);

}  // namespace rinceau
