// A surface on the canvas: turned, zoomed, marked.

#include <array>
#include <cmath>
#include <cstdint>
#include <string>

#include "editor/model/surface_stage.h"
#include "editor/model/surface_view.h"
#include "editor/panels/canvas_parts.h"

namespace rinceau {
namespace {

constexpr double zoom_a_notch = 1.15;
constexpr double degrees_a_notch = 7.5;
constexpr float mark_reach = 10;  ///< pixels about a mark that still hit it, at scale 1
constexpr float still_a_click = 4;

constexpr ImU32 element_color = IM_COL32(0, 122, 255, 255);
constexpr ImU32 seed_color = IM_COL32(255, 149, 0, 255);
constexpr ImU32 rim_color = IM_COL32(255, 255, 255, 255);

bool is_down(ImGuiKey key) { return ImGui::IsKeyDown(ImGui::GetKeyIndex(key)); }

/// By the index: those that turn with the walk are yellow, those that turn against it blue; whole turns are deeper.
ImU32 color_of(const SingularDot& dot, int n) {
    const bool whole = std::abs(dot.index) >= n;
    if (dot.index > 0) return whole ? IM_COL32(226, 88, 34, 255) : IM_COL32(255, 204, 0, 255);
    return whole ? IM_COL32(94, 53, 177, 255) : IM_COL32(30, 136, 229, 255);
}

struct SurfacePlace {
    ImVec2 corner;
    const SurfaceState& surface;
    float scale;

    ImVec2 in_window(SpacePoint p) const {
        const Point at = seen_at(surface.view, p).at;
        return {corner.x + static_cast<float>(at.x), corner.y + static_cast<float>(at.y)};
    }
    Point in_view(ImVec2 p) const { return {p.x - corner.x, p.y - corner.y}; }
};

void draw_dots(const SurfacePlace& place) {
    const SurfaceState& surface = place.surface;
    if (!surface.field || !surface.settings.singular) return;
    constexpr float radius = 4.5F;
    constexpr std::size_t most = 2000;  // more cannot be told apart, and each is looked for behind the surface
    const auto& dots = surface.field->singular;
    for (std::size_t i = 0; i < std::min(dots.size(), most); ++i) {
        if (!is_seen(*surface.stage->surface, surface.view, dots[i].at)) continue;
        const ImVec2 at = place.in_window(dots[i].at);
        ImGui::GetWindowDrawList()->AddCircleFilled(at, radius * place.scale, color_of(dots[i], surface.field->field->n()));
        ImGui::GetWindowDrawList()->AddCircle(at, radius * place.scale, rim_color, 0, place.scale);
    }
}

void draw_mark(const SurfacePlace& place, const SurfaceMark& mark, ImU32 color, const std::string& name,
               const PanelTools& tools) {
    if (!is_seen(*place.surface.stage->surface, place.surface.view, mark.at)) return;
    constexpr float radius = 7;
    const ImVec2 at = place.in_window(mark.at);
    ImDrawList* list = ImGui::GetWindowDrawList();
    list->AddCircle(at, radius * place.scale, rim_color, 0, 4 * place.scale);
    list->AddCircle(at, radius * place.scale, color, 0, 2 * place.scale);
    list->AddText({at.x + radius * place.scale + 2, at.y - ImGui::GetTextLineHeight() / 2}, color,
                  mark.kind.empty() ? "seed" : mark.kind.c_str());
    if (tools.places != nullptr)
        tools.places->push_back({name, at.x - radius * place.scale, at.y - radius * place.scale, at.x + radius * place.scale,
                                 at.y + radius * place.scale});
}

void draw_marks(const SurfacePlace& place, const PanelTools& tools) {
    const SurfaceSettings& settings = place.surface.settings;
    for (std::size_t i = 0; i < settings.field.elements.size(); ++i)
        draw_mark(place, settings.field.elements[i], element_color, "surface/element " + std::to_string(i + 1), tools);
    for (std::size_t i = 0; i < settings.seeds.size(); ++i)
        draw_mark(place, settings.seeds[i], seed_color, "surface/seed " + std::to_string(i + 1), tools);
}

void wheel(Actions& actions, const SurfacePlace& place, double reach) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.MouseWheel == 0) return;
    const Point at = place.in_view(io.MousePos);
    if (mark_near(place.surface, at, reach)) {
        actions.push_back(SurfaceAction{TurnMark{at, reach, degrees_a_notch * io.MouseWheel}});
    } else {
        actions.push_back(SurfaceAction{ZoomSurface{at, std::pow(zoom_a_notch, io.MouseWheel)}});
    }
}

/// The left button turns unless it holds a mark; the others move.
void drags(Actions& actions) {
    const ImGuiIO& io = ImGui::GetIO();
    const Point moved{io.MouseDelta.x, io.MouseDelta.y};
    if (moved.x == 0 && moved.y == 0) return;
    const bool left = ImGui::IsMouseDragging(ImGuiMouseButton_Left, 0);
    const bool pans = ImGui::IsMouseDragging(ImGuiMouseButton_Middle, 0) ||
                      ImGui::IsMouseDragging(ImGuiMouseButton_Right, 0) || (left && is_down(ImGuiKey_Space));
    if (pans) {
        actions.push_back(SurfaceAction{PanSurface{moved}});
    } else if (left) {
        actions.push_back(SurfaceAction{TurnSurface{moved}});
    }
}

void press(Actions& actions, const SurfacePlace& place, double reach) {
    const Point at = place.in_view(ImGui::GetIO().MousePos);
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) actions.push_back(SurfaceAction{PressSurface{at, reach}});
    const float still = still_a_click * place.scale;
    const bool clicked = ImGui::IsMouseReleased(ImGuiMouseButton_Right) &&
                         ImGui::GetIO().MouseDragMaxDistanceSqr[ImGuiMouseButton_Right] < still * still;
    if (clicked) actions.push_back(SurfaceAction{RemoveMark{at, reach}});
}

void say_what_to_do(const EditorState& state, const PanelTools& tools) {
    const SurfaceState& surface = state.surface;
    if (surface.stage) return;
    const std::string text = !surface.reading.empty()  ? "Reading " + surface.reading + " .."
                             : surface.mistake.empty() ? "Drop a mesh here (.obj, .off, .ply), or name one in the panel."
                                                       : surface.mistake;
    const ImVec2 room = ImGui::GetWindowSize();
    const float wide = std::min(room.x * 0.8F, ImGui::CalcTextSize(text.c_str()).x);
    ImGui::SetCursorPos({(room.x - wide) / 2, room.y / 2});
    ImGui::PushTextWrapPos((room.x + wide) / 2 + 1);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    note_place(tools, "surface/hint");
}

}  // namespace

Actions canvas_surface(const EditorState& state, const PanelTools& tools) {
    Actions actions;
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const Point size{std::floor(room.x), std::floor(room.y)};
    if (size.x < 1 || size.y < 1) return actions;
    if (size != state.surface.view.size) actions.push_back(SurfaceAction{ResizeSurfaceView{size}});
    const SurfacePlace place{ImGui::GetCursorScreenPos(), state.surface, tools.scale};
    ImGui::Image(reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(tools.canvas_texture)), room, {0, 1}, {1, 0});
    note_place(tools, "canvas");
    const bool hovered = ImGui::IsItemHovered();
    if (state.surface.stage) {
        ImGui::PushClipRect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), true);
        draw_dots(place);
        draw_marks(place, tools);
        ImGui::PopClipRect();
    }
    say_what_to_do(state, tools);
    const double reach = mark_reach * tools.scale;
    if (state.surface.held) {
        actions.push_back(SurfaceAction{DragSurface{place.in_view(ImGui::GetIO().MousePos)}});
        if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) actions.push_back(SurfaceAction{ReleaseSurface{}});
        return actions;
    }
    if (!hovered) return actions;
    press(actions, place, reach);
    wheel(actions, place, reach);
    drags(actions);
    return actions;
}

}  // namespace rinceau
