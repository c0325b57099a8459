#include "editor/panels/panel.h"

#include <imgui.h>

namespace rinceau {

void note_place(const PanelTools& tools, const std::string& name) {
    if (tools.places == nullptr) return;
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    tools.places->push_back({name, low.x, low.y, high.x, high.y});
}

}  // namespace rinceau
