#pragma once
// Rules: their numbers, their text, their order; undo. Every edit can be undone.

#include <string>
#include <variant>

namespace rinceau {

/// A number of lsystem/numbers.h gets a value. While it is dragged it is previewed, in the steps of its NumberFeel; the last
/// preview is recorded by CommitPreview.
struct SetNumber {
    std::string name;
    double value = 0;
    bool preview = false;
};
/// What is typed into a number's field: begins or goes on. "80*1.5", "+=2", "150%", "bay/2".
struct TypeNumber {
    std::string name;
    std::string text;
};
/// The typed text becomes the number; a mistake is told and the text stays.
struct EnterTyped {};
struct StopTyping {};
/// The number gets the value that it had when the grammar was opened or last analysed.
struct ResetNumber {
    std::string name;
};
/// Edits leave a locked number alone.
struct LockNumber {
    std::string name;
    bool locked = true;
};
/// Only numbers and rules whose names hold the text are listed.
struct FilterRules {
    std::string text;
};
/// Lists details, too: conditions, opacities that are 1, the canvas.
struct ShowRuleDetails {
    bool shown = true;
};
/// What is previewed becomes an edit, or is dropped. After a drop the drag that goes on previews nothing until it ends.
struct CommitPreview {};
struct DropPreview {};
struct UndoEdit {};
struct RedoEdit {};

using RulesAction = std::variant<SetNumber, TypeNumber, EnterTyped, StopTyping, ResetNumber, LockNumber, FilterRules,
                                 ShowRuleDetails, CommitPreview, DropPreview, UndoEdit, RedoEdit>;

}  // namespace rinceau
