#pragma once
// All that a derivation may ask: the surface, its fields by name, the shapes.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "growth/surface/grammar_shape.h"
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

}  // namespace rinceau
