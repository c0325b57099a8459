#include "editor/panels/panel.h"

#include <imgui.h>

#include <algorithm>

namespace rinceau {

void note_place(const PanelTools& tools, const std::string& name) {
    if (tools.places == nullptr || !ImGui::IsItemVisible()) return;
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    const ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 clip_low = list.GetClipRectMin();
    const ImVec2 clip_high = list.GetClipRectMax();
    tools.places->push_back({name, std::max(low.x, clip_low.x), std::max(low.y, clip_low.y), std::min(high.x, clip_high.x),
                             std::min(high.y, clip_high.y)});
}

}  // namespace rinceau
