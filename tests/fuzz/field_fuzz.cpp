// Fields and designs of fields in JSON, on a torus.

#include "growth/surface/field_json.h"
#include "tests/fuzz/fuzz_target.h"
#include "tests/surface/surface_shapes.h"

void rinceau::take_input(std::string_view bytes) {
    static const SurfaceMesh torus = surface_mesh(torus_triangles(6, 4, 2, 0.7));
    is_taken([&] {
        const std::string once = field_json(read_field_json(bytes, torus, "any.json"), torus, FieldFrame::edge);
        require(is_taken([&] {
                    const SurfaceField again = read_field_json(once, torus, "once.json");
                    require(field_json(again, torus, FieldFrame::edge) == once, "a written field reads back as the same");
                }),
                "a written field can be read");
    });
    const FieldDesign design = read_field_design_json(bytes, torus, "any.json");  // which is no field
    field_of_elements(torus, design.n, design.elements, "any.json");
}
