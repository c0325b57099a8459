// Commands of the menu Tools.

#include "editor/model/command.h"

namespace rinceau {
namespace {

template <ToolSection section>
Action open_tool(const EditorState&) {
    return ToolsAction{OpenTool{section}};
}

}  // namespace

std::vector<Command> tools_commands() {
    return {
        {.name = "tools.randomize",
         .menu = "Tools",
         .label = "Randomize..",
         .help = "Random relatives of the drawing: how far angles, distances and scales go astray.",
         .action = open_tool<ToolSection::randomize>},
        {.name = "tools.new_seed",
         .menu = "Tools",
         .label = "Another relative",
         .shortcut = "Ctrl+R",
         .help = "The next seed: the same spreads, other draws. Shown as a preview until it is kept.",
         .action = [](const EditorState&) -> Action { return ToolsAction{NewSeed{}}; }},
        {.name = "tools.symmetrize",
         .menu = "Tools",
         .label = "Symmetrize..",
         .help = "The regular drawing behind this one: what is nearly regular becomes so.",
         .action = open_tool<ToolSection::symmetrize>},
        {.name = "tools.replace",
         .menu = "Tools",
         .label = "Replace a symbol..",
         .help = "Puts another symbol, a drawing or a part of another grammar in the place of a symbol.",
         .action = open_tool<ToolSection::replace>},
        {.name = "tools.keep",
         .menu = "Tools",
         .label = "Keep the preview",
         .shortcut = "Ctrl+Enter",
         .help = "Makes what a tool previews an edit; Esc drops it.",
         .enabled = shows_tool_preview,
         .action = [](const EditorState&) -> Action { return ToolsAction{KeepTool{}}; }},
    };
}

}  // namespace rinceau
