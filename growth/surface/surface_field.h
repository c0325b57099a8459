#pragma once
// Vector, tensor and cross fields on a surface (Li et al. 2010, section 4.2).

#include <optional>
#include <string>
#include <vector>

#include "growth/surface/surface_point.h"

namespace rinceau {

/// Directions that are the same after 1 / n of a turn: n = 1 vectors, 2 symmetric tensors (line fields), 4 crosses.
struct SurfaceField {
    int n = 2;
    /// By vertex, in the vertex's frame: strength * exp(i n angle). A symmetric tensor is isotropic/2 times the identity
    /// plus its traceless part with eigenvalues +- abs(z); angle is that of the major eigenvector.
    std::vector<Complex> values;
    std::vector<double> isotropic;  ///< by vertex: half the trace of the tensor; empty = 0
};

/// A field made ready for many questions. Refers to the surface, which must outlive it.
class FieldOnSurface {
  public:
    /// Throws InputError if the field has not one value for each vertex, or a value that is not finite; values of 0 are
    /// filled from their neighbours.
    FieldOnSurface(const SurfaceMesh& surface, SurfaceField field);

    int n() const { return field_.n; }
    const SurfaceField& field() const { return field_; }
    const SurfaceMesh& surface() const { return *surface_; }

    /// strength * exp(i n angle) in the frame of the point's face; continuous over edges.
    Complex at(SurfacePoint p) const;
    /// Half the trace of the tensor.
    double isotropic_at(SurfacePoint p) const;
    /// n times the index of the face: turns of the field about it minus those of a constant one, in n-th parts.
    int index(int face) const { return index_[static_cast<std::size_t>(face)]; }
    /// Where the field is zero, in the face's frame; of faces with an index.
    Complex zero(int face) const;
    const std::vector<int>& singular_faces() const { return singular_; }
    /// Sum of n * index over all faces; n times the Euler characteristic of a closed surface, exactly.
    long index_sum() const;

  private:
    const SurfaceMesh* surface_;
    SurfaceField field_;
    std::vector<std::array<Complex, 6>> corners_;  ///< by face: corner values seen from both of its edges
    std::vector<signed char> index_;
    std::vector<int> singular_;
    std::vector<Complex> zeros_;  ///< of singular_
};

/// The n-th root of z that is nearest to `near` in direction; of length 1. z is not 0.
Complex root_near(Complex z, int n, Complex near);

}  // namespace rinceau
