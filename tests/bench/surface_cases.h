#pragma once
// The surfaces that the benchmark of patterns works on.

#include <memory>
#include <string>
#include <vector>

#include "growth/surface/surface_mesh.h"
#include "surface_bench.h"

namespace rinceau::test {

struct MeshCase {
    std::string name;
    std::shared_ptr<const SurfaceMesh> surface;  ///< none if it is refused
    std::string refusal;                         ///< why
    bool own = false;                            ///< of samples/surface
};

/// The meshes of samples/surface, then those of the options' folder, by name; what is no surface with the reason.
std::vector<MeshCase> mesh_cases(const SurfaceBenchOptions& options);

/// A whole file. Throws std::runtime_error if it cannot be read.
std::string file_text(const std::string& name);

}  // namespace rinceau::test
