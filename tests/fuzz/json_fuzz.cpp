// Fields and designs of fields, on a torus.

#include "growth/surface/field_json.h"
#include "tests/fuzz/fuzz_target.h"
#include "tests/surface/surface_shapes.h"

void rinceau::take_input(std::string_view bytes) {
    static const SurfaceMesh torus = surface_mesh(torus_triangles(6, 4, 2, 0.7));
    try {
        field_json(read_field_json(bytes, torus, "any.json"), torus, FieldFrame::edge);
    } catch (const InputError&) {
        // what is no field may be a design
    }
    const FieldDesign design = read_field_design_json(bytes, torus, "any.json");
    field_of_elements(torus, design.n, design.elements, "any.json");
}
