#pragma once
// Terminals as L-Py draws them: PlantGL curves for strokes, turtle polygons for fills. Internal to the folder.

#include <string>
#include <string_view>

#include "lsystem/grammar.h"

namespace rinceau {

struct LpyShape {
    std::string definition;  ///< Python before the rules, may be empty
    std::string drawing;     ///< modules that draw it
};

/// Python that definitions need.
extern const std::string_view lpy_shapes_prelude;

/// `name` is the Python name of its curves.
LpyShape lpy_shape(const Terminal& terminal, const Style& style, const std::string& name);

/// What draws nothing and leaves the turtle as it is.
extern const std::string_view lpy_nothing;

}  // namespace rinceau
