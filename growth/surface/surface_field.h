#pragma once
// Vector, tensor and cross fields on a surface (Li et al. 2010, section 4.2).

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "growth/surface/plane_picture.h"
#include "growth/surface/surface_point.h"

namespace rinceau {

/// A field of the plane z = 0 in closed form, of strength 1.
struct PlaneForm {
    bool about_centre = false;  ///< the angle is measured from the ray away from `centre`, not from +x
    Point centre;
    double angle = 0;  ///< radians; about a centre 0 = radial, pi / 2 = vortex, between = spiral
};

/// Directions that are the same after 1 / n of a turn: n = 1 vectors, 2 symmetric tensors (line fields), 4 crosses.
struct SurfaceField {
    int n = 2;
    /// By vertex, in the vertex's frame: strength * exp(i n angle). A symmetric tensor is isotropic times the identity plus
    /// its traceless part with eigenvalues +- abs(z); angle is that of the major eigenvector.
    std::vector<Complex> values;
    std::vector<double> isotropic;  ///< by vertex: half the trace of the tensor; empty = 0
    /// By vertex: a number of its own beside the directions (a picture's brightness, for sizes and colours); empty = none.
    std::vector<double> scalar;
    std::optional<PlaneForm> exact;  ///< then `values` may be empty: they follow from it
    /// In x and y, for any surface: colours and brightness.
    std::shared_ptr<const PlanePicture> picture;
    /// n is 2 and the directions are along the picture's edges, to the pixel; then `values` may be empty.
    bool along_picture = false;
    std::string label = "field";  ///< what messages call it: its file
};

/// A field made ready for many questions. Refers to the surface, which must outlive it.
class FieldOnSurface {
  public:
    /// Throws InputError if n is not 1, 2 or 4, the field has not one value for each vertex, a value is not finite (or
    /// beyond 1e100), or a form of the plane is asked for on a surface that is not flat in z = const. Vertices without a
    /// direction (a value of 0, which would break the sum of the indices and catch walks) are filled: the direction from
    /// their neighbours, with a millionth of the neighbours' strength.
    FieldOnSurface(const SurfaceMesh& surface, SurfaceField field);

    int n() const { return field_.n; }
    /// With its values filled.
    const SurfaceField& field() const { return field_; }
    const SurfaceMesh& surface() const { return *surface_; }

    /// strength * exp(i n angle) in the frame of the point's face; continuous over edges. 0 at singular points only, and
    /// all over a picture of one colour.
    Complex at(SurfacePoint p) const;
    /// Half the trace of the tensor.
    double isotropic_at(SurfacePoint p) const;
    /// The field's number: of `scalar` if it has them, else its picture's brightness in [0, 1], else its strength.
    double scalar_at(SurfacePoint p) const;
    /// Red, green, blue of its picture in [0, 255]; none without a picture.
    std::optional<std::array<double, 3>> colour_at(SurfacePoint p) const;
    /// The length over which a closed form of the plane is differentiated; 0 for fields that values at vertices give.
    double plane_step() const;
    /// n times the index of the face: turns of the field about it minus those of a constant one, in n-th parts.
    int index(int face) const { return index_[static_cast<std::size_t>(face)]; }
    /// Where the field is zero, in the face's frame; of faces with an index.
    Complex zero(int face) const;
    /// By rising face: those with an index.
    const std::vector<int>& singular_faces() const { return singular_; }
    /// Sum of n * index over all faces; n times the Euler characteristic of a closed surface, exactly.
    long index_sum() const;

  private:
    const SurfaceMesh* surface_;
    SurfaceField field_;
    /// By face, in its frame: the value of corner i carried along the edge that starts there, for i = 0, 1, 2; then the
    /// same along the edge that ends there.
    std::vector<std::array<Complex, 6>> corners_;
    std::vector<signed char> index_;
    /// By face: a corner's value turns so far between its two edges that it is turned, not blended.
    std::vector<bool> sharp_;
    std::vector<int> singular_;
    std::vector<Complex> zeros_;  ///< of singular_
};

/// The n-th root of z that is nearest to `near` in direction; of length 1. n is 1, 2 or 4. Of z = 0 it is the direction of
/// `near`.
Complex root_near(Complex z, int n, Complex near);

}  // namespace rinceau
