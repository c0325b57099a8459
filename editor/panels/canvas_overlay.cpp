// What is drawn over the picture: outlines of what is selected, handles.

#include <algorithm>

#include "editor/model/picture_boxes.h"
#include "editor/panels/canvas_parts.h"

namespace rinceau {
namespace {

constexpr ImU32 selected_color = IM_COL32(0, 122, 255, 255);
constexpr ImU32 selected_faint = IM_COL32(0, 122, 255, 90);
constexpr ImU32 hovered_color = IM_COL32(0, 122, 255, 160);
constexpr ImU32 handle_color = IM_COL32(255, 149, 0, 255);
constexpr ImU32 held_color = IM_COL32(255, 59, 48, 255);
constexpr ImU32 rim_color = IM_COL32(255, 255, 255, 255);
constexpr float handle_radius = 7;
constexpr int most_outlines = 2000;  ///< more than can be told apart

void draw_outlines(const EditorState& state, const CanvasPlace& place) {
    const PathModule& module = selected_module(*state.canvas.selection);
    const PictureBoxes boxes(*state.picture);
    ImDrawList* list = ImGui::GetWindowDrawList();
    const int last = std::min(module.last, module.first + most_outlines);
    for (int order = module.first; order < last; ++order) {
        if (is_empty(boxes.own_box(order))) continue;
        const auto corners = boxes.corners(order);
        list->AddQuad(to_window(place, corners[0]), to_window(place, corners[1]), to_window(place, corners[2]),
                      to_window(place, corners[3]), module.last - module.first == 1 ? selected_color : selected_faint);
    }
    const Box box = boxes.box(module.first, module.last);
    if (is_empty(box)) return;
    constexpr float thickness = 2;
    list->AddRect(to_window(place, {box.low.x, box.high.y}), to_window(place, {box.high.x, box.low.y}), selected_color, 0, 0,
                  thickness);
}

void draw_hovered(const EditorState& state, const CanvasPlace& place) {
    const PictureBoxes boxes(*state.picture);
    if (is_empty(boxes.own_box(state.canvas.hovered_item))) return;
    const auto corners = boxes.corners(state.canvas.hovered_item);
    ImGui::GetWindowDrawList()->AddQuad(to_window(place, corners[0]), to_window(place, corners[1]),
                                        to_window(place, corners[2]), to_window(place, corners[3]), hovered_color);
}

Point handle_place(const EditorState& state, const CanvasHandle& handle) {
    const auto& drag = state.canvas.drag;
    return drag ? handle.at + (drag->to - drag->from) : handle.at;
}

void draw_handle(const PanelTools& tools, ImVec2 at, ImU32 color, const std::string& name) {
    const float radius = handle_radius * tools.scale;
    ImDrawList* list = ImGui::GetWindowDrawList();
    list->AddCircleFilled(at, radius, color);
    list->AddCircle(at, radius, rim_color, 0, 2 * tools.scale);
    if (tools.places != nullptr) tools.places->push_back({name, at.x - radius, at.y - radius, at.x + radius, at.y + radius});
}

std::string place_name(const CanvasHandle& handle) {
    const std::string what = handle.numbers.empty() ? "here" : handle.numbers.front().name;
    return std::string("handle/") + handle_name(handle.kind) + ' ' + what;
}

void tell(const PanelTools& tools, ImVec2 at, const std::string& text) {
    const float gap = 16 * tools.scale;
    const float pad = 4 * tools.scale;
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const ImVec2 low{at.x + gap, at.y + gap};
    ImDrawList* list = ImGui::GetWindowDrawList();
    list->AddRectFilled({low.x - pad, low.y - pad}, {low.x + size.x + pad, low.y + size.y + pad},
                        ImGui::GetColorU32(ImGuiCol_PopupBg), pad);
    list->AddText(low, ImGui::GetColorU32(ImGuiCol_Text), text.c_str());
}

}  // namespace

int handle_at(const EditorState& state, const PanelTools& tools, const CanvasPlace& place, ImVec2 window) {
    constexpr float slack = 3;  // a hand is not that steady
    const float reach = (handle_radius + slack) * tools.scale;
    const auto& handles = state.canvas.handles;
    for (std::size_t i = handles.size(); i-- > 0;) {
        const ImVec2 at = to_window(place, handles[i].at);
        const float across = at.x - window.x;
        const float upright = at.y - window.y;
        if (across * across + upright * upright <= reach * reach) return static_cast<int>(i);
    }
    return -1;
}

void draw_canvas_overlay(const EditorState& state, const PanelTools& tools, const CanvasPlace& place) {
    if (state.picture && state.canvas.hovered_item >= 0 && !state.canvas.drag) draw_hovered(state, place);
    if (!state.canvas.selection || !state.picture) return;
    draw_outlines(state, place);
    if (const auto& drag = state.canvas.drag) {
        const ImVec2 at = to_window(place, handle_place(state, drag->handle));
        draw_handle(tools, at, held_color, place_name(drag->handle));
        tell(tools, at, drag->told.empty() ? handle_label(drag->handle, drag->before) : drag->told);
        return;
    }
    for (const CanvasHandle& handle : state.canvas.handles)
        draw_handle(tools, to_window(place, handle.at), handle_color, place_name(handle));
}

}  // namespace rinceau
