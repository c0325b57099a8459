// What happened.

#include <imgui.h>

#include "editor/panels/panel.h"

namespace rinceau {

Actions log_panel(const EditorState& state, const PanelTools&) {
    for (const EditorMessage& message : state.messages) ImGui::TextWrapped("%s", message.text.c_str());
    return {};
}

}  // namespace rinceau
