// The path of the selection: from the axiom down to the element.

#include <algorithm>
#include <array>

#include "editor/panels/canvas_parts.h"

namespace rinceau {

namespace {

void onion_button(Actions& actions, const EditorState& state, const PanelTools& tools) {
    constexpr std::array labels{"Before: off", "Before and after", "Difference"};
    constexpr std::size_t modes = labels.size();
    const auto mode = static_cast<std::size_t>(state.canvas.onion);
    const float width = ImGui::CalcTextSize(labels[1]).x + 2 * ImGui::GetStyle().FramePadding.x;
    ImGui::SameLine(std::max(0.0F, ImGui::GetWindowContentRegionMax().x - width));
    if (ImGui::Button(labels[mode], {width, 0}))
        actions.push_back(CanvasAction{ShowOnion{static_cast<OnionMode>((mode + 1) % modes)}});
    note_place(tools, "canvas/onion");
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("The drawing as it was opened: as a trace (B), or what looks different (D)");
}

}  // namespace

Actions canvas_path_bar(const EditorState& state, const PanelTools& tools) {
    Actions actions;
    const auto& selection = state.canvas.selection;
    if (!selection) {
        ImGui::AlignTextToFramePadding();
        ImGui::TextDisabled("Click an element to see where it comes from");
        onion_button(actions, state, tools);
        return actions;
    }
    const std::vector<std::size_t> levels = shown_levels(*selection);
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const std::size_t level = levels[i];
        if (i > 0) {
            ImGui::SameLine(0, 2 * tools.scale);
            ImGui::TextUnformatted(">");
            ImGui::SameLine(0, 2 * tools.scale);
        }
        const bool here = level == selection->level;
        if (here) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
        ImGui::PushID(static_cast<int>(level));
        if (ImGui::Button(level_label(selection->path[level]).c_str())) actions.push_back(CanvasAction{SelectLevel{level}});
        note_place(tools, "canvas/level " + std::to_string(i));
        const std::string counts = level_counts(*selection, level);
        if (ImGui::IsItemHovered() && !counts.empty()) ImGui::SetTooltip("%s", counts.c_str());
        ImGui::PopID();
        if (here) ImGui::PopStyleColor();
    }
    onion_button(actions, state, tools);
    return actions;
}

}  // namespace rinceau
