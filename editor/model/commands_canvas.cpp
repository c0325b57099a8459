// Commands of the menu View that concern the canvas.

#include "editor/model/command.h"

namespace rinceau {

std::vector<Command> canvas_commands() {
    return {
        {.name = "view.fit",
         .menu = "View",
         .label = "Fit",
         .shortcut = "0",
         .help = "Shows the whole picture.",
         .action = [](const EditorState&) -> Action { return CanvasAction{FitView{}}; }},
    };
}

}  // namespace rinceau
