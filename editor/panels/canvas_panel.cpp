// The canvas: the picture, moved and zoomed, with what is selected.

#include <cmath>
#include <cstdint>

#include "editor/model/growth_view.h"
#include "editor/model/surface_view.h"
#include "editor/panels/canvas_parts.h"

namespace rinceau {
namespace {

constexpr double zoom_a_notch = 1.15;
constexpr float pan_a_notch = 40;   ///< pixels of a sideways wheel, at scale 1
constexpr float click_reach = 3;    ///< pixels beside an element that still hit it, at scale 1
constexpr float still_a_click = 4;  ///< pixels that the mouse may move in a click, at scale 1

bool is_down(ImGuiKey key) { return ImGui::IsKeyDown(ImGui::GetKeyIndex(key)); }

void zoom_and_pan(Actions& actions, const CanvasPlace& place, const PanelTools& tools) {
    const ImGuiIO& io = ImGui::GetIO();
    const Point mouse{io.MousePos.x - place.corner.x, io.MousePos.y - place.corner.y};
    if (io.MouseWheel != 0) actions.push_back(CanvasAction{ZoomView{mouse, std::pow(zoom_a_notch, io.MouseWheel)}});
    if (io.MouseWheelH != 0) actions.push_back(CanvasAction{PanView{{io.MouseWheelH * pan_a_notch * tools.scale, 0}}});
}

/// The left button, too: a touchpad has no other that is as easy to hold.
void pan_by_drag(Actions& actions) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool left = ImGui::IsMouseDragging(ImGuiMouseButton_Left, is_down(ImGuiKey_Space) ? 0 : -1);
    const bool pans =
        left || ImGui::IsMouseDragging(ImGuiMouseButton_Middle, 0) || ImGui::IsMouseDragging(ImGuiMouseButton_Right, 0);
    if (pans && (io.MouseDelta.x != 0 || io.MouseDelta.y != 0))
        actions.push_back(CanvasAction{PanView{{io.MouseDelta.x, io.MouseDelta.y}}});
}

void drag_handle(Actions& actions, const EditorState& state, const CanvasPlace& place) {
    const ImGuiIO& io = ImGui::GetIO();
    const Point to = from_window(place, io.MousePos);
    if (to != state.canvas.drag->to) actions.push_back(CanvasAction{DragHandle{to, io.KeyCtrl}});
    if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) actions.push_back(CanvasAction{ReleaseHandle{}});
}

double reach(const PanelTools& tools, const CanvasPlace& place) { return click_reach * tools.scale / place.view.zoom; }

void hover(Actions& actions, const EditorState& state, const PanelTools& tools, const CanvasPlace& place) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.MouseDelta.x == 0 && io.MouseDelta.y == 0) return;
    if (state.picture) actions.push_back(CanvasAction{HoverCanvas{from_window(place, io.MousePos), reach(tools, place)}});
}

void click(Actions& actions, const PanelTools& tools, const CanvasPlace& place) {
    const ImGuiIO& io = ImGui::GetIO();
    const float still = still_a_click * tools.scale;
    if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {  // its first click has gone one level up
        actions.push_back(CanvasAction{StepSelection{2}});
        return;
    }
    if (io.MouseClickedLastCount[ImGuiMouseButton_Left] > 1) return;
    if (!ImGui::IsMouseReleased(ImGuiMouseButton_Left) || io.MouseDragMaxDistanceSqr[0] > still * still) return;
    if (is_down(ImGuiKey_Space)) return;
    actions.push_back(CanvasAction{ClickCanvas{from_window(place, io.MousePos), reach(tools, place), io.KeyAlt}});
}

}  // namespace

Actions canvas_panel(const EditorState& state, const PanelTools& tools) {
    if (shows_surface(state)) return canvas_surface(state, tools);
    Actions actions = canvas_path_bar(state, tools);
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const Point size{std::floor(room.x), std::floor(room.y)};
    if (size.x < 1 || size.y < 1) return actions;
    if (size != state.canvas.view.size) actions.push_back(CanvasAction{ResizeCanvas{size}});
    const CanvasPlace place{ImGui::GetCursorScreenPos(), state.canvas.view};
    ImGui::Image(reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(tools.canvas_texture)), room, {0, 1}, {1, 0});
    note_place(tools, "canvas");
    const bool hovered = ImGui::IsItemHovered();
    if (ImGui::IsWindowFocused() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter), false))
        actions.push_back(CanvasAction{StepSelection{1}});
    ImGui::PushClipRect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), true);
    if (!shows_grown(state)) draw_canvas_overlay(state, tools, place);
    draw_growth_overlay(state, tools, place, hovered);
    ImGui::PopClipRect();
    if (state.canvas.drag) {
        drag_handle(actions, state, place);
        return actions;
    }
    if (paint_growth(actions, state, tools, place, hovered)) return actions;
    if (!hovered) {
        if (state.canvas.hovered_item >= 0) actions.push_back(CanvasAction{LeaveCanvas{}});
        return actions;
    }
    zoom_and_pan(actions, place, tools);
    pan_by_drag(actions);
    if (shows_grown(state) || brush_on_canvas(state) != GrowthBrush::none) return actions;
    const int handle = handle_at(state, tools, place, ImGui::GetIO().MousePos);
    if (handle >= 0 && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
        const Point at = from_window(place, ImGui::GetIO().MousePos);
        actions.push_back(CanvasAction{GrabHandle{static_cast<std::size_t>(handle), at}});
        return actions;
    }
    hover(actions, state, tools, place);
    click(actions, tools, place);
    return actions;
}

}  // namespace rinceau
