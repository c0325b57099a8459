// L-systems, drawn flat and laid on a torus.

#include "growth/surface/grow_drawing.h"
#include "lsystem/grammar_text.h"
#include "lsystem/interpret.h"
#include "tests/fuzz/fuzz_target.h"
#include "tests/surface/surface_shapes.h"

void rinceau::take_input(std::string_view bytes) {
    static const SurfaceMesh torus = surface_mesh(torus_triangles(12, 8, 2, 0.7));
    check_grammar(bytes, "any.lsys");
    const Grammar grammar = parse_grammar(bytes, "any.lsys");
    InterpretOptions options;
    options.derive.max_modules = 2000;
    options.derive.max_seconds = 1;
    const std::vector<Placement> placements = interpret(grammar, options);
    constexpr std::size_t few = 60;  // laying takes its time
    if (placements.size() > few) return;
    GrowDrawingOptions laying;
    laying.max_shapes = few;
    grow_drawing(grammar, torus, nullptr, laying);
}
