#pragma once
// A field that stands for numbers at the vertices.

#include "growth/surface/surface_field.h"

namespace rinceau {

/// The numbers, and as vectors (n = 1) their gradient. Throws InputError as FieldOnSurface does.
SurfaceField field_of_numbers(const SurfaceMesh& surface, std::vector<double> numbers, const std::string& label);

}  // namespace rinceau
