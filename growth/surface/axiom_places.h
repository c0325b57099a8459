#pragma once
// Where axioms begin (Li et al. 2010, section 4.3: scopes are placed in the field and given a symbol).

#include <vector>

#include "growth/surface/shape_expressions.h"
#include "growth/surface/surface_field.h"

namespace rinceau {

struct AxiomPlace {
    SurfacePoint at;
    Complex x{1, 0};  ///< of length 1, in the frame of at's face
};

/// X is that direction 1 of the guiding field which is nearest to space's x axis laid into the surface; without a field, or
/// where it is zero, it is that axis itself, or y where the surface is too steep for it. Scattered places depend on `key`.
/// `field` is that of `each`. Throws InputError at the axiom's place for a vertex that
/// the surface has not.
std::vector<AxiomPlace> axiom_places(const CompiledShapeAxiom& axiom, const SurfaceMesh& surface,
                                     const FieldOnSurface* guide, const FieldOnSurface* field, DrawKey key);

}  // namespace rinceau
