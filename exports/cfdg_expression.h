#pragma once
// Expressions in Context Free's language. Internal to the folder.

#include <functional>
#include <map>
#include <optional>
#include <string>

#include "lsystem/expression.h"

namespace rinceau {

/// Name in the grammar -> name in the file.
using NameMap = std::map<std::string, std::string>;

/// An expression's text; `atom` = it needs no parentheses as an operand.
struct CfdgText {
    std::string text;
    bool atom = true;
    bool truth = false;  ///< a condition, not a number
};

/// Nothing if the text would be absurdly long (nested % and round write their operands several times).
std::optional<CfdgText> cfdg_expression(const Expression& expression, const NameMap& names);

/// As a number: a condition is 1 or 0.
CfdgText as_number(const CfdgText& text);
/// As a condition: a number holds if it is not 0.
std::string as_condition(const CfdgText& text);
/// "5", "m", "(m + 1)": fit for an adjustment.
std::string as_operand(const CfdgText& text);

}  // namespace rinceau
