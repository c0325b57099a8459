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
void perform_one(Update& update, const SetDepth& action);
void perform_one(Update& update, const SetSeed& action);

// In update_rules_structure.cpp.
void perform_one(Update& update, const AddProduction& action);
void perform_one(Update& update, const RemoveProduction& action);
void perform_one(Update& update, const KeepProduction& action);
void perform_one(Update& update, const MoveProduction& action);
void perform_one(Update& update, const RenameSymbol& action);
void perform_one(Update& update, const CommentProduction& action);
void perform_one(Update& update, const WriteCard& action);
void perform_one(Update& update, const EnterCard& action);
void perform_one(Update& update, const StopCard& action);

// In update_rules_text.cpp.
void perform_one(Update& update, const ShowRules& action);
void perform_one(Update& update, const WriteText& action);
void perform_one(Update& update, const TextChecked& action);
void perform_one(Update& update, const ApplyText& action);
void perform_one(Update& update, const RevertText& action);
void perform_one(Update& update, const ShowTextPlace& action);
void perform_one(Update& update, const TextPlaceShown& action);

/// A text without changes is that of the document's grammar.
void refresh_text(EditorState& state);

/// The drag of a number ends: what it shows becomes an edit. False if no number was dragged to another value.
bool commit_drag(Update& update);

}  // namespace rinceau
