// Growth on a surface: meshes, fields designed anew whenever their settings have changed, growth in the background.

#include "editor/model/update_surface.h"

#include <utility>

#include "editor/model/surface_stage.h"
#include "editor/model/update_growth.h"

namespace rinceau {
namespace {

void end_surface_growth(Update& update) {
    SurfaceState& surface = update.state.surface;
    if (!surface.growing) return;
    surface.growing = surface.stopping = false;
    update.requests.push_back(EndSurface{false});
}

void perform_one(Update& update, const OpenMesh& action) {
    SurfaceState& surface = update.state.surface;
    open_growth_panel(update.state, GrowthTab::surface);
    surface.reading = action.path;
    surface.mistake.clear();
    update.requests.push_back(ReadMesh{++surface.stage_job, action.path});
}

void perform_one(Update& update, const OpenShapeGrammar& action) {
    open_growth_panel(update.state, GrowthTab::surface);
    update.state.surface.settings.grammar = action.path;
    if (!update.state.surface.stage)
        tell(update, MessageKind::note, "The shape grammar will grow on a surface: open a mesh (.obj, .off or .ply)");
}

void perform_one(Update& update, const SetSurface& action) { update.state.surface.settings = action.settings; }

void begin_growing(Update& update) {
    SurfaceState& surface = update.state.surface;
    open_growth_panel(update.state, GrowthTab::surface);
    if (!surface.stage) {
        tell(update, MessageKind::mistake, "There is no surface to grow on: open a mesh (.obj, .off or .ply) first");
        return;
    }
    if (surface.settings.grammar.empty() && update.state.document.resolved->terminals.empty()) {
        tell(update, MessageKind::mistake, "There is nothing that could grow: open a drawing, or name a shape grammar");
        return;
    }
    surface.growing = true;
    surface.stopping = false;
    surface.step_name.clear();
    surface.fraction = 0;
    SurfaceOrder order{surface.stage, surface.field ? surface.field->field : nullptr, update.state.document.resolved,
                       surface.settings};
    update.requests.push_back(GrowOnSurface{++surface.job, std::make_shared<const SurfaceOrder>(std::move(order))});
}

void perform_one(Update& update, const GrowSurface&) {
    update.state.surface.settings.steps = -1;
    begin_growing(update);
}

void perform_one(Update& update, const StepSurface& action) {
    SurfaceState& surface = update.state.surface;
    const bool goes_on = surface.settings.steps >= 0 && surface.grown;
    surface.settings.steps = (goes_on ? surface.settings.steps : 0) + action.rules;
    begin_growing(update);
}

void perform_one(Update& update, const StopSurface&) {
    SurfaceState& surface = update.state.surface;
    if (!surface.growing || surface.stopping) return;
    surface.stopping = true;
    update.requests.push_back(EndSurface{true});
}

void perform_one(Update& update, const ClearSurface&) {
    end_surface_growth(update);
    update.state.surface.grown.reset();
    update.state.surface.settings.steps = -1;
}

void perform_one(Update& update, const ExportSurface& action) {
    SurfaceState& surface = update.state.surface;
    if (!surface.stage || action.path.empty()) return;
    surface.writing = true;
    update.requests.push_back(WriteSurface{action.path, surface.stage, surface.grown, surface.view});
}

void perform_one(Update& update, const MeshRead& action) {
    SurfaceState& surface = update.state.surface;
    if (action.job != surface.stage_job) return;
    if (!action.stage) {
        surface.mistake = action.mistake;
        tell(update, MessageKind::mistake, action.mistake);
        surface.reading.clear();
        return;
    }
    end_surface_growth(update);
    surface.stage = action.stage;
    surface.settings.mesh = std::exchange(surface.reading, {});
    surface.settings.seeds.clear();
    surface.settings.field.elements.clear();
    surface.held.reset();
    surface.grown.reset();
    surface.fit_pending = true;
    fit_surface_if_pending(surface);
    for (const std::string& warning : action.stage->warnings) tell(update, MessageKind::warning, warning);
    tell(update, MessageKind::note, "The surface has " + action.stage->told);
}

void perform_one(Update& update, const FieldDesigned& action) {
    SurfaceState& surface = update.state.surface;
    if (action.job != surface.field_job) return;
    surface.designing = false;
    surface.field = action.field;
    if (!action.mistake.empty()) tell(update, MessageKind::mistake, action.mistake);
}

void perform_one(Update& update, const SurfaceProgress& action) {
    SurfaceState& surface = update.state.surface;
    if (action.job != surface.job || !surface.growing) return;
    surface.step_name = action.step;
    surface.fraction = action.fraction;
}

void perform_one(Update& update, const SurfaceGrown& action) {
    SurfaceState& surface = update.state.surface;
    if (action.job != surface.job || !surface.growing) return;
    if (action.grown) surface.grown = action.grown;
    if (!action.done) return;
    surface.growing = surface.stopping = false;
    if (!action.mistake.empty()) {
        tell(update, MessageKind::mistake, action.mistake);
    } else {
        tell(update, MessageKind::note, "Grown: " + surface.grown->told);
    }
}

void perform_one(Update& update, const SurfaceExported& action) {
    update.state.surface.writing = false;
    const bool failed = !action.mistake.empty();
    tell(update, failed ? MessageKind::mistake : MessageKind::note, failed ? action.mistake : "Written: " + action.path);
}

/// Streamlines and singular points follow the marks as they are dragged.
void follow_field(Update& update) {
    SurfaceState& surface = update.state.surface;
    const FieldSettings& wanted = surface.settings.field;
    if (!surface.stage || (surface.designed == wanted && surface.designed_on == surface.stage)) return;
    surface.designed = wanted;
    surface.designed_on = surface.stage;
    ++surface.field_job;
    const bool none = wanted.source == FieldSettings::Source::none ||
                      (wanted.source == FieldSettings::Source::elements && wanted.elements.empty());
    surface.designing = !none;
    if (none) {
        surface.field.reset();
    } else {
        update.requests.push_back(DesignField{surface.field_job, surface.stage, wanted, surface.settings.spacing});
    }
}

}  // namespace

void follow_surface(Update& update) { follow_field(update); }

void perform(Update& update, const SurfaceAction& action) {
    std::visit([&](const auto& one) { perform_one(update, one); }, action);
}

}  // namespace rinceau
