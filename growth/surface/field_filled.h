#pragma once
// A field made fit for questions: checked, sampled from its closed form, and with a direction at every vertex.

#include "growth/surface/surface_field.h"

namespace rinceau {

/// z to the power n, for the few small n of fields.
constexpr Complex power(Complex z, int n) {
    Complex product{1, 0};
    for (int i = 0; i < n; ++i) product = product * z;
    return product;
}

/// The closed form's value at a place of the plane, against the x axis; 0 at its centre.
Complex value_of(const PlaneForm& form, int n, Point place);

/// Throws InputError as FieldOnSurface says; no value of the result is 0.
SurfaceField filled_field(const SurfaceMesh& surface, SurfaceField field);

}  // namespace rinceau
