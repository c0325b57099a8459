#pragma once
// All that a derivation may ask: the surface, its fields by name, the shapes.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "geometry/progress.h"
#include "growth/surface/field_source.h"
#include "growth/surface/grammar_shape.h"
#include "growth/surface/shape_grammar.h"
#include "growth/surface/shape_programs.h"
#include "growth/surface/shape_sources.h"
#include "growth/surface/surface_field.h"

namespace rinceau {

struct WorldField {
    std::string name;
    std::shared_ptr<const FieldOnSurface> field;
};

struct SurfaceWorld {
    std::shared_ptr<const SurfaceMesh> surface;
    std::vector<WorldField> fields;  ///< the first guides translations unless an option names another
    std::vector<GrammarShape> shapes;
    bool plane = false;  ///< the surface is a piece of the plane z = 0
};

/// The piece of the plane that a grammar grows on without a surface: about the origin, `option plane = WIDTH height = HEIGHT
/// cells = N`, N squares along the longer side; 1 by 1 and 96 unless the grammar says otherwise, as high as wide.
struct PlanePiece {
    double width = 1, height = 1;
    int cells = 96;
};
/// Throws InputError for sizes that are not positive and numbers of cells below 1 or above 2000.
PlanePiece plane_piece(const ShapeGrammar& grammar);
/// z = 0, facing +z.
TriangleMesh plane_mesh(const PlanePiece& piece);

/// The grammar's fields and shapes on a surface, or without one on a piece of the plane. Files are read by the names that
/// the grammar gives them. Throws InputError with the place of the source or of the file.
SurfaceWorld make_world(const ShapeGrammar& grammar, std::shared_ptr<const SurfaceMesh> surface,
                        const ReadNamedFile& read_file, std::uint64_t seed = 1, const Progress& progress = {});

/// What a grammar says of a field, its numbers evaluated. Throws InputError for numbers that have no value.
FieldSource field_source_of(const ShapeSource& source, const ShapeGrammar& grammar, const ShapeGrammarSetting& setting);

/// A field from a source as a grammar writes it behind the '=': "smoothest n = 4". Throws InputError.
std::shared_ptr<const FieldOnSurface> make_world_field(const ShapeSource& source, const ShapeGrammar& grammar,
                                                       const SurfaceMesh& surface, const ReadNamedFile& read_file,
                                                       std::uint64_t seed = 1, const Progress& progress = {});

/// What the grammar's numbers may name of a surface.
ShapeGrammarSetting grammar_setting(const SurfaceMesh& surface, std::uint64_t seed);

/// Other values of params: as NAME=VALUE on a command line, where VALUE is an expression. Throws InputError at the grammar's
/// file for a name that is none, with what was perhaps meant.
ShapeGrammar with_params(ShapeGrammar grammar, const std::vector<std::pair<std::string, Expression>>& values);

}  // namespace rinceau
