// Commands of the menus View and Help that concern the window.

#include "editor/model/command.h"

namespace rinceau {

std::vector<Command> shell_commands() {
    return {
        {.name = "help.help",
         .menu = "Help",
         .label = "Commands and keys",
         .shortcut = "F1",
         .help = "Lists all commands with their keys.",
         .action = [](const EditorState& state) -> Action { return ShellAction{ShowHelp{!state.shell.help}}; }},
    };
}

}  // namespace rinceau
