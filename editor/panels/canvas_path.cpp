// The path of the selection: from the axiom down to the element.

#include "editor/panels/canvas_parts.h"

namespace rinceau {

Actions canvas_path_bar(const EditorState& state, const PanelTools& tools) {
    Actions actions;
    const auto& selection = state.canvas.selection;
    if (!selection) {
        ImGui::AlignTextToFramePadding();
        ImGui::TextDisabled("Click an element to see where it comes from");
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
    return actions;
}

}  // namespace rinceau
