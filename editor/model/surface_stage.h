#pragma once
// What growth on a surface works with and makes: values, made where it may take its time.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "editor/model/surface_settings.h"
#include "geometry/progress.h"
#include "growth/mesh/triangle_mesh.h"
#include "growth/surface/surface_field.h"
#include "growth/surface/surface_pattern.h"
#include "lsystem/grammar.h"

namespace rinceau {

/// A mesh that was read.
struct SurfaceStage {
    std::string path;
    std::shared_ptr<const SurfaceMesh> surface;
    std::shared_ptr<const MeshAssembly> ground;  ///< as it is drawn
    std::vector<std::string> warnings;
    std::string told;  ///< "5,856 faces, closed, genus 0"
};

/// A singular point as it is drawn.
struct SingularDot {
    SpacePoint at;
    int index = 0;  ///< n times the index
};

struct StageField {
    std::shared_ptr<const SurfaceMesh> surface;  ///< that the field refers to
    std::shared_ptr<const FieldOnSurface> field;
    std::shared_ptr<const std::vector<std::vector<SpacePoint>>> streamlines;
    std::vector<SingularDot> singular;
    std::string told;  ///< "6 singular points, index sum 2 = Euler characteristic"
};

struct GrownSurface {
    std::shared_ptr<const MeshAssembly> assembly;  ///< without the ground
    std::string told;
    int steps = 0;  ///< rules that were applied
};

/// Text of a file by its name, as named by `from`. Throws OutputError or InputError.
using ReadNamed = std::function<std::string(const std::string& name)>;

/// `text` is what the file of that name holds. Throws InputError and LimitError.
SurfaceStage surface_stage(const std::string& path, const std::string& text);

/// The field by the settings, with streamlines for the eye. Throws InputError.
StageField stage_field(const SurfaceStage& stage, const FieldSettings& settings, double spacing,
                       const Progress& progress = {});

/// What is to be grown on a stage.
struct SurfaceOrder {
    std::shared_ptr<const SurfaceStage> stage;
    std::shared_ptr<const FieldOnSurface> field;  ///< null = none
    std::shared_ptr<const Grammar> rules;         ///< the document's, if no shape grammar is named
    SurfaceSettings settings;
};

/// Growth that is watched: `stop` ends it with what stands, `show` gets what stands now and then.
struct SurfaceWatch {
    std::function<bool()> stop;
    std::function<bool()> wants_look;
    std::function<void(GrownSurface)> show;
    Progress progress;
};

/// Throws InputError, LimitError and what watch.progress throws.
GrownSurface grown_on_surface(const SurfaceOrder& order, const ReadNamed& read, const SurfaceWatch& watch = {});

}  // namespace rinceau
