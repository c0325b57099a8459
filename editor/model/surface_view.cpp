#include "editor/model/surface_view.h"

#include "editor/model/growth_view.h"
#include "editor/model/surface_stage.h"

namespace rinceau {

bool shows_surface(const EditorState& state) {
    return growth_is_open(state) && state.growth.settings.tab == GrowthTab::surface;
}

const SurfaceMark& mark_of(const SurfaceSettings& settings, const HeldMark& which) {
    return which.kind == SurfaceTool::seed ? settings.seeds[which.index] : settings.field.elements[which.index];
}

std::optional<HeldMark> mark_near(const SurfaceState& surface, Point at, double reach) {
    if (!surface.stage) return std::nullopt;
    std::optional<HeldMark> nearest;
    const auto look = [&](SurfaceTool kind, const std::vector<SurfaceMark>& marks) {
        for (std::size_t i = 0; i < marks.size(); ++i) {
            const double distance = abs(seen_at(surface.view, marks[i].at).at - at);
            if (distance > reach || !is_seen(*surface.stage->surface, surface.view, marks[i].at)) continue;
            reach = distance;
            nearest = HeldMark{kind, i};
        }
    };
    look(SurfaceTool::element, surface.settings.field.elements);
    look(SurfaceTool::seed, surface.settings.seeds);
    return nearest;
}

}  // namespace rinceau
