#pragma once
// Growth on a surface: what a user does and what comes back.

#include <cstdint>
#include <memory>
#include <string>
#include <variant>

#include "editor/model/surface_settings.h"
#include "geometry/point.h"

namespace rinceau {

struct SurfaceStage;  // surface_stage.h
struct StageField;    // surface_stage.h
struct GrownSurface;  // surface_stage.h

/// Read a mesh, or a shape grammar for the mesh that is there.
struct OpenMesh {
    std::string path;
};
struct OpenShapeGrammar {
    std::string path;
};
struct SetSurface {
    SurfaceSettings settings;
};

// Window points of the view, y down.
struct ResizeSurfaceView {
    Point size;
};
struct TurnSurface {
    Point pixels;
};
struct PanSurface {
    Point pixels;
};
struct ZoomSurface {
    Point at;
    double factor = 1;
};
struct FitSurface {};

/// With a tool: takes the mark within `reach` pixels, or puts a new one there. Then it follows, until it is let go.
struct PressSurface {
    Point at;
    double reach = 0;
};
struct DragSurface {
    Point to;
};
struct ReleaseSurface {};
/// Turns or removes the mark within reach; without one the last that was put.
struct TurnMark {
    Point at;
    double reach = 0;
    double degrees = 0;
};
struct RemoveMark {
    Point at;
    double reach = 0;
};
struct ClearMarks {
    SurfaceTool of = SurfaceTool::element;
};

/// All rules are applied, or so many more than before.
struct GrowSurface {};
struct StepSurface {
    int rules = 1;
};
struct StopSurface {};
struct ClearSurface {};
/// The ending says how: .glb, .obj, .ply, .png.
struct ExportSurface {
    std::string path;
};

// Answers; a `mistake` that is not empty says why there is nothing.
struct MeshRead {
    std::uint64_t job = 0;
    std::shared_ptr<const SurfaceStage> stage;
    std::string mistake;
};
struct FieldDesigned {
    std::uint64_t job = 0;
    std::shared_ptr<const StageField> field;
    std::string mistake;
};
struct SurfaceProgress {
    std::uint64_t job = 0;
    std::string step;
    double fraction = 0;
};
struct SurfaceGrown {
    std::uint64_t job = 0;
    std::shared_ptr<const GrownSurface> grown;
    std::string mistake;
    bool done = true;
};
struct SurfaceExported {
    std::string path;
    std::string mistake;
};

struct SurfaceAction : std::variant<OpenMesh, OpenShapeGrammar, SetSurface, ResizeSurfaceView, TurnSurface, PanSurface,
                                    ZoomSurface, FitSurface, PressSurface, DragSurface, ReleaseSurface, TurnMark, RemoveMark,
                                    ClearMarks, GrowSurface, StepSurface, StopSurface, ClearSurface, ExportSurface, MeshRead,
                                    FieldDesigned, SurfaceProgress, SurfaceGrown, SurfaceExported> {
    using variant::variant;
    SurfaceAction(const SurfaceAction&);
    SurfaceAction(SurfaceAction&&) noexcept;
    SurfaceAction& operator=(const SurfaceAction&);
    SurfaceAction& operator=(SurfaceAction&&) noexcept;
    ~SurfaceAction();
};

}  // namespace rinceau
