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
        {.name = "tools.ring",
         .menu = "Tools",
         .label = "Make a ring or a row..",
         .help = "Bends a row to a ring of as many elements, or straightens a ring.",
         .action = open_tool<ToolSection::ring>},
        {.name = "tools.group",
         .menu = "Tools",
         .label = "Group modules..",
         .help = "Modules that stand side by side become a rule of their own.",
         .action = open_tool<ToolSection::group>},
        {.name = "tools.inline",
         .menu = "Tools",
         .label = "Inline a rule..",
         .help = "Puts a rule in the place of its symbol everywhere; the picture stays the same.",
         .action = open_tool<ToolSection::inline_rule>},
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
