// The surface on the canvas: the eye goes round it, marks are put on it.

#include <utility>

#include "editor/model/surface_stage.h"
#include "editor/model/update_surface.h"

namespace rinceau {
namespace {

std::vector<SurfaceMark>& marks_of(SurfaceSettings& settings, SurfaceTool kind) {
    return kind == SurfaceTool::seed ? settings.seeds : settings.field.elements;
}

/// Elements are of no use to a field that is not made from them.
void use_elements(SurfaceSettings& settings) {
    if (settings.field.source != FieldSettings::Source::elements) settings.field.source = FieldSettings::Source::elements;
}

}  // namespace

void fit_surface_if_pending(SurfaceState& surface) {
    constexpr double smallest = 2;  // pixels: the view has not been seen yet
    if (!surface.fit_pending || !surface.stage || surface.view.size.x < smallest) return;
    const auto [low, high] = bounds(surface.stage->surface->mesh);
    surface.view = fitted_to(surface.view, low, high);
    surface.fit_pending = false;
}

void perform_one(Update& update, const ResizeSurfaceView& action) {
    update.state.surface.view.size = action.size;
    fit_surface_if_pending(update.state.surface);
}

void perform_one(Update& update, const TurnSurface& action) {
    update.state.surface.view = turned_by(update.state.surface.view, action.pixels);
}

void perform_one(Update& update, const PanSurface& action) {
    update.state.surface.view = panned_by(update.state.surface.view, action.pixels);
}

void perform_one(Update& update, const ZoomSurface& action) {
    update.state.surface.view = zoomed_at(update.state.surface.view, action.at, action.factor);
}

void perform_one(Update& update, const FitSurface&) {
    update.state.surface.fit_pending = true;
    fit_surface_if_pending(update.state.surface);
}

void perform_one(Update& update, const PressSurface& action) {
    SurfaceState& surface = update.state.surface;
    if (!surface.stage || surface.settings.tool == SurfaceTool::turn) return;
    if (const auto known = mark_near(surface, action.at, action.reach)) {
        surface.held = known;
        return;
    }
    const auto under = surface_point_under(*surface.stage->surface, surface.view, action.at);
    if (!under) return;
    const SurfaceTool kind = surface.settings.tool;
    const bool element = kind == SurfaceTool::element;
    if (element) use_elements(surface.settings);
    std::vector<SurfaceMark>& marks = marks_of(surface.settings, kind);
    marks.push_back({element ? surface.settings.element : "", position_in_space(*surface.stage->surface, *under), 0});
    surface.held = HeldMark{kind, marks.size() - 1};
}

void perform_one(Update& update, const DragSurface& action) {
    SurfaceState& surface = update.state.surface;
    if (!surface.held || !surface.stage) return;
    const auto under = surface_point_under(*surface.stage->surface, surface.view, action.to);
    if (!under) return;  // it stays at the rim
    const SpacePoint at = position_in_space(*surface.stage->surface, *under);
    marks_of(surface.settings, surface.held->kind)[surface.held->index].at = at;
}

void perform_one(Update& update, const ReleaseSurface&) { update.state.surface.held.reset(); }

void perform_one(Update& update, const TurnMark& action) {
    SurfaceState& surface = update.state.surface;
    if (const auto which = mark_near(surface, action.at, action.reach))
        marks_of(surface.settings, which->kind)[which->index].angle += action.degrees;
}

void perform_one(Update& update, const RemoveMark& action) {
    SurfaceState& surface = update.state.surface;
    const auto which = mark_near(surface, action.at, action.reach);
    if (!which) return;
    surface.held.reset();
    std::vector<SurfaceMark>& marks = marks_of(surface.settings, which->kind);
    marks.erase(marks.begin() + static_cast<std::ptrdiff_t>(which->index));
}

void perform_one(Update& update, const ClearMarks& action) {
    update.state.surface.held.reset();
    marks_of(update.state.surface.settings, action.of).clear();
}

}  // namespace rinceau
