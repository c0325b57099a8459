#pragma once
// What `rinceau field` is told.

#include <optional>
#include <string>
#include <vector>

#include <CLI/App.hpp>

#include "cli/surface_options.h"
#include "growth/mesh/mesh_glb_write.h"
#include "growth/surface/field_json.h"
#include "growth/surface/field_source.h"

namespace rinceau {

/// --element TYPE,VERTEX[,ANGLE[,DECAY[,WEIGHT]]]
struct ElementWord {
    FieldElementKind kind = FieldElementKind::regular;
    int vertex = 0;
    double angle = 0;  ///< degrees from the way of +x
    double decay = FieldElement{}.decay;
    double weight = FieldElement{}.weight;
};

/// --smooth-at VERTEX,RADIUS,ROUNDS
struct SmoothingRegion {
    int vertex = 0;
    double radius = 0;  ///< diagonals
    int rounds = 0;
};

struct FieldVerbOptions {
    std::string surface;        ///< name of a mesh; empty = a piece of the plane
    std::optional<Point> size;  ///< of that piece
    bool repair = false;

    std::vector<ElementWord> elements;
    std::vector<FieldSource> sources;  ///< all others that were given
    int n = 2;
    bool n_given = false;

    double smooth = 0;
    int rounds = 0;
    std::vector<SmoothingRegion> regions;

    std::vector<std::string> outputs;
    FieldFrame frame = FieldFrame::space;
    std::string report;
    double spacing = 0;  ///< of lines, diagonals; 0 = the picture's own
    bool minor = false;
    bool points = true;
    UpAxis up = UpAxis::y;
    std::optional<LookFrom> view;
    int width = 900;
};

void add_field_options(CLI::App& verb, FieldVerbOptions& options);

/// Throws CLI::ValidationError unless there is one source of the field, and for names of outputs that say nothing;
/// OutputError for outputs that cannot be written.
void expect_field_options(const FieldVerbOptions& options);

}  // namespace rinceau
