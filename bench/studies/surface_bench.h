#pragma once
// The parts of the benchmark of patterns on surfaces.

#include <algorithm>
#include <ctime>
#include <string>
#include <vector>

#include "growth_lines.h"

namespace rinceau::test {

struct SurfaceBenchOptions {
    std::string meshes;    ///< a folder of more meshes; may be empty
    std::string only;      ///< the parts whose names hold this; empty = all
    std::string pictures;  ///< a folder for a look at each pattern; may be empty
    bool csv = false;

    bool wants(const std::string& name) const { return only.empty() || name.find(only) != std::string::npos; }
};

/// Seconds of the processor that the fastest of `times` calls takes; the machine is shared.
template <class Work>
double best_seconds(int times, const Work& work) {
    double best = any;
    for (int i = 0; i < times; ++i) {
        const std::clock_t begin = std::clock();
        work();
        best = std::min(best, processor_seconds(begin));
    }
    return best;
}

struct MeshCase;

/// Which meshes load, how fast, and what is refused, with reason and place.
void mesh_rows(GrowthLines& lines, const SurfaceBenchOptions& options, const std::vector<MeshCase>& meshes);
/// Polar maps against closed forms, with their times.
void polar_map_lines(GrowthLines& lines, const SurfaceBenchOptions& options);
/// Indices, curvature, the smoothest fields.
void field_lines(GrowthLines& lines, const SurfaceBenchOptions& options, const std::vector<MeshCase>& meshes);
/// Moves along fields: how many a second, how exact.
void walk_lines(GrowthLines& lines, const SurfaceBenchOptions& options, const std::vector<MeshCase>& meshes);
/// Box placements a second, against all pairs.
void collision_lines(GrowthLines& lines, const SurfaceBenchOptions& options);
/// Outlines laid on surfaces: how many a second, folds, how many shrunk, split and dropped by size.
void laying_lines(GrowthLines& lines, const SurfaceBenchOptions& options, const std::vector<MeshCase>& meshes);
/// Patterns of the paper's sizes: seconds and bytes.
void size_lines(GrowthLines& lines, const SurfaceBenchOptions& options, const std::vector<MeshCase>& meshes);
/// The paper's patterns on meshes: a row each, judged by the bars of docs/growth.md.
void pattern_rows(GrowthLines& lines, const SurfaceBenchOptions& options, const std::vector<MeshCase>& meshes);
/// The rules of drawings grown on meshes: a row each.
void drawing_rows(GrowthLines& lines, const SurfaceBenchOptions& options, const std::vector<MeshCase>& meshes);

}  // namespace rinceau::test
