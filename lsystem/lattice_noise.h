#pragma once
// Smooth noise over the line, the plane and space: the same number at the same place, always. Internal to the folder.

#include <span>

namespace rinceau {

/// Of one to three coordinates, in [-1, 1], with continuous first and second derivatives; features are about 1 long. Random
/// values at whole coordinates, blended between them (Perlin 2002's polynomial). Not a number for coordinates that are none
/// or of size 2^52 and more.
double lattice_noise(std::span<const double> place);

}  // namespace rinceau
