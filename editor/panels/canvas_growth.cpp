// Growth on the canvas: brushes, strokes, lines between neighbours.

#include <cmath>
#include <span>

#include "editor/model/grown_pattern.h"
#include "editor/model/growth_view.h"
#include "editor/panels/canvas_parts.h"

namespace rinceau {
namespace {

constexpr ImU32 flow_color = IM_COL32(0, 122, 255, 220);
constexpr ImU32 boundary_color = IM_COL32(255, 59, 48, 230);
constexpr ImU32 edge_color = IM_COL32(52, 168, 83, 200);
constexpr ImU32 brush_color = IM_COL32(255, 149, 0, 230);
constexpr std::size_t most_edges = 20'000;  ///< more than can be told apart
constexpr float edge_reach = 6;             ///< pixels beside an edge that still hit it, at scale 1
constexpr float stroke_step = 3;            ///< pixels from one corner of a stroke to the next, at scale 1

void draw_edges(std::span<const std::array<Point, 2>> edges, const CanvasPlace& place, const PanelTools& tools) {
    ImDrawList* list = ImGui::GetWindowDrawList();
    for (const auto& [a, b] : edges.first(std::min(edges.size(), most_edges)))
        list->AddLine(to_window(place, a), to_window(place, b), edge_color, 1.5F * tools.scale);
}

/// Half-way along the window's points, so that short strokes show theirs, too.
void draw_arrow(std::span<const ImVec2> points, ImU32 color, float size) {
    const std::size_t middle = std::max<std::size_t>(1, points.size() / 2);
    const ImVec2 tip = points[middle];
    const ImVec2 before = points[middle - 1];
    const float length = std::hypot(tip.x - before.x, tip.y - before.y);
    if (length <= 0) return;
    const ImVec2 ahead{(tip.x - before.x) / length * size, (tip.y - before.y) / length * size};
    ImGui::GetWindowDrawList()->AddTriangleFilled({tip.x + ahead.x, tip.y + ahead.y},
                                                  {tip.x - ahead.y / 2, tip.y + ahead.x / 2},
                                                  {tip.x + ahead.y / 2, tip.y - ahead.x / 2}, color);
}

void draw_stroke(const DrawnStroke& stroke, const CanvasPlace& place, const PanelTools& tools, bool flow) {
    constexpr float thickness = 2.5F;
    constexpr float arrow = 12;
    std::vector<ImVec2> points;
    for (const Point& corner : stroke) points.push_back(to_window(place, corner));
    const ImU32 color = flow ? flow_color : boundary_color;
    ImGui::GetWindowDrawList()->AddPolyline(points.data(), static_cast<int>(points.size()), color, 0,
                                               thickness * tools.scale);
    if (flow && points.size() >= 2) draw_arrow(points, color, arrow * tools.scale);
}

bool is_painting(const EditorState& state) { return state.growth.sprayed || !state.growth.stroke.empty(); }

double reach(const PanelTools& tools, const CanvasPlace& place, float pixels) {
    return pixels * tools.scale / place.view.zoom;
}

}  // namespace

void draw_growth_overlay(const EditorState& state, const PanelTools& tools, const CanvasPlace& place, bool hovered) {
    if (!growth_is_open(state) || state.growth.settings.tab != GrowthTab::arrangement) return;
    const GrowthSource* source = current_source(state);
    if (shows_edges(state) && shows_grown(state)) {
        draw_edges(state.growth.grown->edges, place, tools);
    } else if (shows_edges(state) && source != nullptr && source->exemplar) {
        draw_edges(edges_of(*source->exemplar), place, tools);
    }
    const GrowthBrush brush = brush_on_canvas(state);
    const bool draws = brush == GrowthBrush::flow || brush == GrowthBrush::boundary;
    if (shows_grown(state) || draws) {
        for (const DrawnStroke& stroke : state.growth.guides->flow) draw_stroke(stroke, place, tools, true);
        for (const DrawnStroke& stroke : state.growth.guides->boundary) draw_stroke(stroke, place, tools, false);
    }
    if (draws) draw_stroke(state.growth.stroke, place, tools, brush == GrowthBrush::flow);
    if (brush == GrowthBrush::spray && (hovered || is_painting(state))) {
        const auto radius = static_cast<float>(spray_radius(state) * place.view.zoom);
        ImGui::GetWindowDrawList()->AddCircle(ImGui::GetIO().MousePos, radius, brush_color, 0, 2 * tools.scale);
    }
}

bool paint_growth(Actions& actions, const EditorState& state, const PanelTools& tools, const CanvasPlace& place,
                  bool hovered) {
    const GrowthBrush brush = brush_on_canvas(state);
    if (brush == GrowthBrush::none) return false;
    const Point at = from_window(place, ImGui::GetIO().MousePos);
    const double near = reach(tools, place, brush == GrowthBrush::flip ? edge_reach : stroke_step);
    if (is_painting(state)) {
        actions.push_back(GrowthAction{DragBrush{at, near}});
        if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) actions.push_back(GrowthAction{ReleaseBrush{near}});
        return true;
    }
    const bool pans = ImGui::IsKeyDown(ImGui::GetKeyIndex(ImGuiKey_Space));
    if (hovered && !pans && ImGui::IsMouseClicked(ImGuiMouseButton_Left))
        actions.push_back(GrowthAction{PressBrush{at, near}});
    return false;
}

}  // namespace rinceau
