#pragma once
// What `rinceau grow` is told.

#include <optional>
#include <string>
#include <vector>

#include <CLI/App.hpp>

#include "cli/surface_options.h"
#include "growth/mesh/mesh_glb_write.h"
#include "growth/surface/derive_shapes.h"
#include "growth/surface/grow_drawing.h"

namespace rinceau {

struct GrowVerbOptions {
    std::string input;
    std::string surface;  ///< name of a mesh; empty = the plane
    std::string field;    ///< name of a file, or a source as grammars write it; empty = the grammar's own
    std::string output;
    std::string report;
    std::optional<Point> size;  ///< of the plane's piece
    bool repair = false;
    std::vector<std::string> params;  ///< NAME=VALUE
    std::uint64_t seed = 1;
    std::optional<long> max_shapes;  ///< none: the grammar's, or 1,000,000
    double seconds = 0;              ///< 0 = no limit
    bool keep_partial = false;

    bool with_surface = false;
    GlbInstancing instancing = GlbInstancing::gpu;
    UpAxis up = UpAxis::y;
    std::optional<LookFrom> view;
    int width = 0;  ///< of pictures, pixels; 0 = their own

    GrowDrawingOptions drawing;  ///< but for the start
    std::optional<int> vertex;
    std::optional<SpacePoint> at;
    std::vector<std::string> drawing_only;  ///< options that were given and are for drawings alone
    std::vector<std::string> shapes_only;   ///< likewise for shape grammars
    int threads = 0;                        ///< of the analysis of a drawing
};

void add_grow_options(CLI::App& verb, GrowVerbOptions& options);

/// Throws CLI::ValidationError for options that do not go together and names of outputs that say nothing, OutputError for
/// outputs that cannot be written.
void expect_grow_options(const GrowVerbOptions& options);

}  // namespace rinceau
