#pragma once
// Grammars from text, grown on surfaces with closed forms, for tests.

#include <memory>
#include <string>

#include "growth/surface/derive_shapes.h"
#include "growth/surface/parse_shape_grammar.h"
#include "surface_shapes.h"

namespace rinceau {

inline GrammarShape test_shape(std::string name, CollideAs collide = CollideAs::box) {
    GrammarShape shape;
    shape.name = std::move(name);
    shape.low = {-0.5, -0.5, 0};
    shape.high = {0.5, 0.5, 1};
    shape.collide = collide;
    return shape;
}

inline SurfaceWorld bare_world(TriangleMesh mesh) {
    SurfaceWorld world;
    world.surface = std::make_shared<SurfaceMesh>(surface_mesh(std::move(mesh)));
    return world;
}

/// The plane [0, side]^2 with four faces for each unit square, and no field: moves are straight.
inline SurfaceWorld plane_world(int side = 10, double jitter = 0.2) {
    return bare_world(plane_triangles(2 * side, 2 * side, 0.5, jitter));
}

/// Every shape statement becomes a box of size 1, or a disc if its kind is disc.
inline SurfacePattern grown(const std::string& text, SurfaceWorld world, ShapeDerivationOptions options = {}) {
    const ShapeGrammar grammar = parse_shape_grammar(text, "test.fgsg");
    for (const ShapeSource& source : grammar.shapes)
        world.shapes.push_back(test_shape(source.name, source.kind == "disc" ? CollideAs::disc : CollideAs::box));
    return derive_shapes(grammar, world, options_of(grammar, std::move(options)));
}

inline int count_of(const SurfacePattern& pattern, const std::string& name) {
    int count = 0;
    for (const PatternShape& shape : pattern.placed)
        count += pattern.shapes[static_cast<std::size_t>(shape.shape)].name == name ? 1 : 0;
    return count;
}

}  // namespace rinceau
