// The terminals: what is drawn, and how often.

#include <imgui.h>

#include "editor/panels/panel.h"

namespace rinceau {

Actions terminals_panel(const EditorState& state, const PanelTools& tools) {
    for (const Terminal& terminal : shown_document(state).resolved->terminals) {
        ImGui::TextUnformatted(terminal.symbol.c_str());
        note_place(tools, "terminals/" + terminal.symbol);
    }
    return {};
}

}  // namespace rinceau
