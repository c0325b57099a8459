// Commands of the menu File.

#include "editor/model/command.h"

namespace rinceau {

std::vector<Command> file_commands() {
    return {
        {.name = "file.save",
         .menu = "File",
         .label = "Save",
         .shortcut = "Ctrl+S",
         .help = "Writes the grammar to its file.",
         .enabled = [](const EditorState& state) { return !state.file.path.empty(); },
         .action = [](const EditorState&) -> Action { return FileAction{SaveFile{}}; }},
        {.name = "file.quit",
         .menu = "File",
         .label = "Quit",
         .shortcut = "Ctrl+Q",
         .help = "Leaves; asks if something is not saved.",
         .action = [](const EditorState&) -> Action { return FileAction{QuitEditor{}}; }},
    };
}

}  // namespace rinceau
