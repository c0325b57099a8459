#pragma once
// What the program says on standard error.

#include <string>
#include <vector>

#include "scene/input_error.h"

namespace rinceau {

/// One line.
void say(const std::string& line);

/// Says so without needing any.
void say_memory_does_not_suffice() noexcept;

/// "warning: file:line:column: message", a line each.
void say_warnings(const std::vector<Warning>& warnings);

}  // namespace rinceau
