#pragma once
// The panel of rules.

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "editor/model/rule_sheet.h"

namespace rinceau {

/// A number while it is dragged.
struct DraggedNumber {
    std::string name;
    double start = 0;      ///< its value before
    double wanted = 0;     ///< where the mouse is
    bool dropped = false;  ///< by Esc: the rest of the drag does nothing
};

/// A number while its new value is typed.
struct TypedNumber {
    std::string name;
    std::string text;
    std::string mistake;  ///< in what was entered; empty = none
};

/// What is open in the panel of rules.
struct RulesState {
    std::string filter;    ///< shows numbers and rules whose name holds this; empty = all
    bool details = false;  ///< lists all numbers
    std::optional<DraggedNumber> dragged;
    std::optional<TypedNumber> typed;
    std::shared_ptr<const RuleSheet> sheet;   ///< of what is shown; null until something has happened
    std::shared_ptr<const RuleSheet> origin;  ///< of Document::origin; null = it has none
};

}  // namespace rinceau
