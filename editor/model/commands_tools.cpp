// Commands of the menu Tools.

#include "editor/model/command.h"

namespace rinceau {

std::vector<Command> tools_commands() {
    return {
        {.name = "tools.symmetrize",
         .menu = "Tools",
         .label = "Symmetrize",
         .shortcut = "",
         .help = "The regular drawing behind this one.",
         .action = [](const EditorState&) -> Action { return ToolsAction{SymmetrizeGrammar{}}; }},
    };
}

}  // namespace rinceau
