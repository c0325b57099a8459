// L-systems that draw little, laid on a torus.

#include "growth/surface/grow_drawing.h"
#include "lsystem/grammar_text.h"
#include "lsystem/interpret.h"
#include "tests/fuzz/fuzz_target.h"
#include "tests/surface/surface_shapes.h"

namespace rinceau {

void take_input(std::string_view bytes) {
    static const SurfaceMesh torus = surface_mesh(torus_triangles(12, 8, 2, 0.7));
    constexpr std::size_t few = 12;  // laying takes its time
    const Grammar grammar = parse_grammar(bytes, "any.lsys");
    InterpretOptions options;
    options.derive.max_modules = 200;
    if (interpret(grammar, options).size() > few) return;
    GrowDrawingOptions laying;
    laying.max_shapes = few;
    grow_drawing(grammar, torus, nullptr, laying);
}

}  // namespace rinceau
