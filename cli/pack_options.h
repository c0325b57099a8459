#pragma once
// What `rinceau pack` is told.

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <CLI/App.hpp>

#include "files/files.h"
#include "growth/aggregate/aggregate_options.h"
#include "growth/aggregate/exclusive_region.h"
#include "growth/aggregate/height_map.h"
#include "growth/mesh/mesh_glb_write.h"

namespace rinceau {

struct PackVerbOptions {
    std::vector<std::string> shapes;  ///< drawings, or meshes
    std::string output;
    std::optional<Point> size;
    std::string region;
    bool tile = false;
    AggregateOptions fill;  ///< density, flow and shares are still to be read
    ExclusiveRegionOptions exclusive;
    std::vector<std::string> drawn_regions;
    std::string flow;
    std::string density;
    std::vector<std::pair<std::string, double>> shares;  ///< by symbol
    std::vector<std::string> meshes;
    UpAxis up = UpAxis::y;
    std::vector<std::string> raised;
    std::string height_map;
    std::string shaded;
    std::vector<std::string> sulci;
    HeightMapOptions relief;
    int width = 0;  ///< of pictures, pixels; 0 = their own
    std::string report;
    int threads = 0;
    double seconds = 0;  ///< of filling; 0 = no limit
};

/// Are the shapes meshes?
bool from_meshes(const PackVerbOptions& options);

/// Does every shape keep the circle about it?
bool keeps_circles(const PackVerbOptions& options);

void add_pack_options(CLI::App& verb, PackVerbOptions& options);

/// Throws CLI::ValidationError for options that do not go together or names of outputs that say nothing, OutputError for
/// outputs that cannot be written.
void expect_pack_options(const PackVerbOptions& options);

}  // namespace rinceau
