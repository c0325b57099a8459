#pragma once
// What the parts of update() for rules share. Internal to the folder.

#include "editor/model/update_parts.h"

namespace rinceau {

// In update_rules_numbers.cpp.
void perform_one(Update& update, const SetNumber& action);
void perform_one(Update& update, const TypeNumber& action);
void perform_one(Update& update, const EnterTyped& action);
void perform_one(Update& update, const StopTyping& action);
void perform_one(Update& update, const ResetNumber& action);
void perform_one(Update& update, const LockNumber& action);
void perform_one(Update& update, const FilterRules& action);
void perform_one(Update& update, const ShowRuleDetails& action);

/// The drag of a number ends: what it shows becomes an edit. False if no number was dragged to another value.
bool commit_drag(Update& update);

/// What is previewed is shown no more.
void drop_preview(Update& update);

}  // namespace rinceau
