#pragma once
// Setting numbers of a grammar by name (docs/editing.md).

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lsystem/edit_result.h"
#include "lsystem/expression.h"
#include "lsystem/grammar.h"

namespace rinceau {

/// One change. `value` may use the grammar's constants.
struct NumberEdit {
    enum class How : unsigned char { set, add, subtract, multiply, divide };
    std::string name;  ///< of numbers.h; '*' stands for any characters, and then all numbers that are listed and fit are set
    How how = How::set;
    Expression value;
};

/// "Row.count=12", "bay=80*1.5", "Row.count+=2", "bay*=1.5", "bay/=2", "bay=150%" (of what it is). Throws InputError.
NumberEdit parse_number_edit(std::string_view text);

struct SetOptions {
    bool keep_rings_closed = true;
    /// A ring's turn that no whole count closes becomes the nearest one that one does, as while it is dragged; else it throws.
    bool nearest_ring = false;
    bool say_changes = true;  ///< false: `changes` stays empty, which is quicker
};

/// The edits one after the other. A ring whose count is set gets the turn that closes it, one whose turn is set the count;
/// several rules that share a constant change together, and `changes` says so. Everything else stays as it is, comments too.
/// Throws InputError for unknown names (with the nearest ones), values out of range, and turns that no count closes.
EditResult set_numbers(const Grammar& grammar, std::span<const NumberEdit> edits, const SetOptions& options = {});

}  // namespace rinceau
