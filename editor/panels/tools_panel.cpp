// The tools that change the whole grammar.

#include <imgui.h>

#include "editor/panels/panel.h"

namespace rinceau {

Actions tools_panel(const EditorState&, const PanelTools& tools) {
    Actions actions;
    if (ImGui::Button("Symmetrize")) actions.push_back(ToolsAction{SymmetrizeGrammar{}});
    note_place(tools, "tools/Symmetrize");
    return actions;
}

}  // namespace rinceau
