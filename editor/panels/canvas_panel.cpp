// The canvas: the picture, moved and zoomed.

#include <imgui.h>

#include <cmath>
#include <cstdint>

#include "editor/panels/panel.h"

namespace rinceau {

Actions canvas_panel(const EditorState& state, const PanelTools& tools) {
    Actions actions;
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const Point size{std::floor(room.x), std::floor(room.y)};
    if (size.x < 1 || size.y < 1) return actions;
    if (size != state.canvas.view.size) actions.push_back(CanvasAction{ResizeCanvas{size}});
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::Image(reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(tools.canvas_texture)), room, {0, 1}, {1, 0});
    note_place(tools, "canvas");
    const ImGuiIO& io = ImGui::GetIO();
    if (!ImGui::IsItemHovered()) return actions;
    constexpr double zoom_a_notch = 1.15;
    const Point mouse{io.MousePos.x - corner.x, io.MousePos.y - corner.y};
    if (io.MouseWheel != 0) actions.push_back(CanvasAction{ZoomView{mouse, std::pow(zoom_a_notch, io.MouseWheel)}});
    const bool pans =
        ImGui::IsMouseDragging(ImGuiMouseButton_Middle, 0) || ImGui::IsMouseDragging(ImGuiMouseButton_Right, 0);
    if (pans && (io.MouseDelta.x != 0 || io.MouseDelta.y != 0))
        actions.push_back(CanvasAction{PanView{{io.MouseDelta.x, io.MouseDelta.y}}});
    return actions;
}

}  // namespace rinceau
