#pragma once
// Records refer to each other by int, containers of the standard library count by std::size_t.

#include <cstddef>

namespace rinceau {

/// An index that is known not to be negative, as containers take it.
constexpr std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// The place of a cell in a table that is kept row by row, `columns` cells in each.
constexpr std::size_t table_index(int row, int column, int columns) { return at(row) * at(columns) + at(column); }

}  // namespace rinceau
