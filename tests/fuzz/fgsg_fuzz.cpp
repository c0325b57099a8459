// Shape grammars: checked, written, and grown on a torus for a short while.

#include <algorithm>

#include "growth/surface/check_shape_grammar.h"
#include "growth/surface/derive_shapes.h"
#include "growth/surface/parse_shape_grammar.h"
#include "growth/surface/shape_grammar_text.h"
#include "growth/surface/surface_world.h"
#include "tests/fuzz/fuzz_target.h"
#include "tests/surface/surface_shapes.h"

namespace rinceau {
namespace {

/// Whatever file a grammar asks for.
std::string any_file(const std::string& name) {
    if (name.ends_with(".svg"))
        return "<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'>"
               "<path d='M1 1H8L5 8Z' fill='#27a'/></svg>";
    if (name.ends_with(".obj")) return "v 1 1 1\nv 5 1 1\nv 1 3 1\nv 1 1 2\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    if (name.ends_with(".json")) return R"({"n": 2, "elements": [{"type": "regular", "vertex": 5}], "smooth": 0.03})";
    throw InputError({name}, "expected the name of a file that is there");
}

}  // namespace

void take_input(std::string_view bytes) {
    static const auto torus = std::make_shared<const SurfaceMesh>(surface_mesh(torus_triangles(12, 8, 2, 0.7)));
    const bool mistaken = !inspect_shape_grammar(bytes, "any.fgsg").mistakes.empty();
    ShapeGrammar grammar;
    const bool parsed = is_taken([&] { grammar = parse_shape_grammar(bytes, "any.fgsg"); });
    require(parsed || mistaken, "what cannot be read has a mistake");
    if (!parsed) return;
    const std::string text = to_text(grammar);
    require(
        is_taken([&] { require(to_text(parse_shape_grammar(text)) == text, "a written grammar reads back as the same"); }),
        "a written grammar can be read");

    const SurfaceWorld world = make_world(grammar, torus, any_file);
    ShapeDerivationOptions options = options_of(grammar);
    options.max_shapes = std::min(options.max_shapes, 100L);
    options.max_rules = std::min(options.max_rules, 1000L);
    options.max_seconds = 1;
    const SurfacePattern pattern = derive_shapes(grammar, world, options);
    assembly_of(pattern, *torus);
}

}  // namespace rinceau
