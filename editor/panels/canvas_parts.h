#pragma once
// What the files of the canvas share. Internal to the folder.

#include <imgui.h>

#include "editor/panels/panel.h"

namespace rinceau {

/// Where the canvas stands in the window.
struct CanvasPlace {
    ImVec2 corner;
    ViewTransform view;
};

inline ImVec2 to_window(const CanvasPlace& place, Point scene) {
    const Point canvas = to_canvas(place.view, scene);
    return {place.corner.x + static_cast<float>(canvas.x), place.corner.y + static_cast<float>(canvas.y)};
}
inline Point from_window(const CanvasPlace& place, ImVec2 window) {
    return to_scene_point(place.view, {window.x - place.corner.x, window.y - place.corner.y});
}

/// The bar with the path of the selection.
Actions canvas_path_bar(const EditorState& state, const PanelTools& tools);

/// Outlines of what is selected, and the handles.
void draw_canvas_overlay(const EditorState& state, const PanelTools& tools, const CanvasPlace& place);

/// Strokes, lines between neighbours and the brush of growth.
void draw_growth_overlay(const EditorState& state, const PanelTools& tools, const CanvasPlace& place, bool hovered);

/// What the mouse does with a brush of growth. True while something is painted: the mouse is for that alone.
bool paint_growth(Actions& actions, const EditorState& state, const PanelTools& tools, const CanvasPlace& place,
                  bool hovered);

/// A surface in the picture's place.
Actions canvas_surface(const EditorState& state, const PanelTools& tools);

/// Index of the handle under the point of the window; -1 = none.
int handle_at(const EditorState& state, const PanelTools& tools, const CanvasPlace& place, ImVec2 window);

}  // namespace rinceau
