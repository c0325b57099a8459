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

/// The field has its directions from a form of the plane, not from values at vertices.
inline bool of_plane(const SurfaceField& field) { return field.exact || field.along_picture; }

/// The value of a form of the plane at a place, against the x axis; 0 at its centre.
Complex plane_value(const SurfaceField& field, Point place);

/// Is the surface a piece of the plane z = const, facing +z?
bool is_plane(const SurfaceMesh& surface);

/// Throws InputError as FieldOnSurface says; no value of the result is 0.
SurfaceField filled_field(const SurfaceMesh& surface, SurfaceField field);

}  // namespace rinceau
