// Commands of the menu Edit.

#include "editor/model/command.h"

namespace rinceau {

std::vector<Command> rules_commands() {
    return {
        {.name = "edit.undo",
         .menu = "Edit",
         .label = "Undo",
         .shortcut = "Ctrl+Z",
         .help = "Takes the last edit back.",
         .enabled = [](const EditorState& state) { return !state.history.past.empty(); },
         .action = [](const EditorState&) -> Action { return RulesAction{UndoEdit{}}; }},
        {.name = "edit.redo",
         .menu = "Edit",
         .label = "Redo",
         .shortcut = "Ctrl+Y Ctrl+Shift+Z",
         .help = "Does again what was undone.",
         .enabled = [](const EditorState& state) { return !state.history.future.empty(); },
         .action = [](const EditorState&) -> Action { return RulesAction{RedoEdit{}}; }},
    };
}

}  // namespace rinceau
