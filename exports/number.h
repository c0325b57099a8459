#pragma once
// Numbers in exported text.

#include <string>

#include "lsystem/expression.h"

namespace rinceau {

/// Shortest text that reads back as the same number: "-0.5", "1e-07".
inline std::string number_of(double value) { return to_text(number_expression(value)); }

}  // namespace rinceau
