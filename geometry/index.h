#pragma once
// Records refer to each other by int, containers of the standard library count by std::size_t.

#include <cstddef>

namespace rinceau {

/// An index that is known not to be negative, as containers take it.
constexpr std::size_t at(int index) { return static_cast<std::size_t>(index); }

}  // namespace rinceau
