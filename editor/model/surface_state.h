#pragma once
// Growth on a surface: the mesh, its field, what has grown. Nothing of it is the document.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "editor/model/orbit_view.h"
#include "editor/model/surface_settings.h"

namespace rinceau {

struct SurfaceStage;  // surface_stage.h
struct StageField;    // surface_stage.h
struct GrownSurface;  // surface_stage.h

/// A mark that the mouse holds.
struct HeldMark {
    SurfaceTool kind = SurfaceTool::element;
    std::size_t index = 0;
};

struct SurfaceState {
    SurfaceSettings settings;
    OrbitView view;
    bool fit_pending = true;

    std::shared_ptr<const SurfaceStage> stage;  ///< null = no mesh is there
    std::string reading;                        ///< file that is being read; empty = none
    std::string mistake;                        ///< why the last file could not be read
    std::uint64_t stage_job = 0;

    std::shared_ptr<const StageField> field;  ///< null = none is designed
    std::optional<FieldSettings> designed;    ///< the settings that `field` was made by, or is being made by
    std::shared_ptr<const SurfaceStage> designed_on;
    bool designing = false;
    std::uint64_t field_job = 0;

    std::optional<HeldMark> held;

    bool growing = false;
    bool stopping = false;
    std::uint64_t job = 0;
    std::string step_name;
    double fraction = 0;
    std::shared_ptr<const GrownSurface> grown;  ///< null = nothing
    bool writing = false;
};

/// Is something asked for that will change what is seen?
inline bool surface_is_busy(const SurfaceState& surface) {
    return !surface.reading.empty() || surface.designing || surface.growing || surface.writing;
}

}  // namespace rinceau
