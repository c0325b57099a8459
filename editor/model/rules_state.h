#pragma once
// The panel of rules.

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "editor/model/rule_sheet.h"
#include "editor/model/rules_actions.h"

namespace rinceau {

/// A number while it is dragged.
struct DraggedNumber {
    std::string name;
    double start = 0;      ///< its value before
    double wanted = 0;     ///< where the mouse is
    double set = 0;        ///< what it was last set to, in the steps of its NumberFeel
    bool dropped = false;  ///< by Esc: the rest of the drag does nothing
};

/// A number while its new value is typed.
struct TypedNumber {
    std::string name;
    std::string text;
    std::string mistake;  ///< in what was entered; empty = none
};

/// A name or comment while it is written.
struct WrittenCard {
    CardField field = CardField::name;
    int production = 0;
    std::string text;
    std::string mistake;  ///< in what was entered; empty = none
};

/// A production that is used elsewhere and shall be removed.
struct AskedRemoval {
    int production = 0;
    std::string reason;  ///< where it is used
};

/// What is open in the panel of rules.
struct RulesState {
    std::string filter;    ///< shows numbers and rules whose name holds this; empty = all
    bool details = false;  ///< lists all numbers
    RulesView view = RulesView::rules;
    std::optional<DraggedNumber> dragged;
    std::optional<TypedNumber> typed;
    std::optional<WrittenCard> written;
    std::optional<AskedRemoval> removal;
    RuleText text;                             ///< kept while it is changed, whatever is shown
    int depth = -1;                            ///< of the deepest derivation of `measured`; -1 = not known
    std::shared_ptr<const Grammar> measured;   ///< ready for drawing; null = none
    std::shared_ptr<const Grammar> measuring;  ///< the depth of this one was asked for; null = of none
    std::shared_ptr<const RuleSheet> sheet;    ///< of what is shown; null until something has happened
    std::shared_ptr<const RuleSheet> origin;   ///< of Document::origin; null = it has none
};

}  // namespace rinceau
