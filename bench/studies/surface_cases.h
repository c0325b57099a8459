#pragma once
// The surfaces that the benchmark of patterns works on.

#include <memory>
#include <string>
#include <vector>

#include "growth/surface/surface_mesh.h"
#include "scene/input_error.h"
#include "surface_bench.h"

namespace rinceau::test {

struct MeshCase {
    std::string name;
    std::shared_ptr<const SurfaceMesh> surface;   ///< none if it is refused
    std::string refusal;                          ///< why
    std::shared_ptr<const SurfaceMesh> repaired;  ///< of what is refused, if repair is possible
    std::vector<Warning> warnings;                ///< of the surface or of its repair
    double seconds = 0;                           ///< of the processor: reading, checking, making the surface, or refusing
    bool own = false;                             ///< of samples/surface
};

/// The meshes of samples/surface, then those of the options' folder, by name; what is no surface with the reason.
std::vector<MeshCase> mesh_cases(const SurfaceBenchOptions& options);

/// A surface without a border.
inline bool is_closed(const MeshCase& one) { return one.surface && one.surface->border_edges == 0; }

/// A whole file. Throws std::runtime_error if it cannot be read.
std::string file_text(const std::string& name);

}  // namespace rinceau::test
