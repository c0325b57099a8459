#include "how_to/legend_panel.h"

#include <imgui.h>

#include <string>

#include "exports/plain_color.h"
#include "how_to/colour_legend.h"

namespace rinceau {

namespace {

ImVec4 shown_color(Color color) {
    constexpr float most = 255;
    return {static_cast<float>(color.red) / most, static_cast<float>(color.green) / most,
            static_cast<float>(color.blue) / most, 1};
}

/// True while the mouse is on it.
bool row(const PanelTools& tools, const LegendColour& entry) {
    const std::string name = hex_text(entry.color);
    ImGui::BeginGroup();
    constexpr ImGuiColorEditFlags flat = ImGuiColorEditFlags_NoTooltip | ImGuiColorEditFlags_NoDragDrop;
    ImGui::ColorButton(name.c_str(), shown_color(entry.color), flat);
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    ImGui::Text("%s  %zu %s", name.c_str(), entry.elements, entry.elements == 1 ? "element" : "elements");
    ImGui::EndGroup();
    note_place(tools, "legend/" + name);
    return ImGui::IsItemHovered();
}

}  // namespace

Actions legend_panel(const EditorState& state, const PanelTools& tools) {
    Actions actions;
    if (!state.picture) {
        ImGui::TextDisabled("Nothing is drawn.");
        return actions;
    }
    const std::vector<LegendColour> legend = colour_legend(*state.picture);
    int hovered = -1;
    for (std::size_t i = 0; i < legend.size(); ++i)
        if (row(tools, legend[i])) hovered = static_cast<int>(i);
    // What the mouse was on when the last frame was drawn is the widget's own memory; what is lit is the editor's state.
    constexpr int none = -1;
    int& before = *ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("hovered"), none);
    if (hovered == before) return actions;
    before = hovered;
    HoverItems hover;
    if (hovered != none) hover.lit = lit_by_colour(*state.picture, legend[static_cast<std::size_t>(hovered)].color);
    actions.push_back(CanvasAction{hover});
    return actions;
}

}  // namespace rinceau
