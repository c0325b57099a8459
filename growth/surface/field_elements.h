#pragma once
// Fields designed from elements placed on a surface (Li et al. 2010, section 4.2, equation 3 and figure 6).

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "geometry/progress.h"
#include "growth/surface/surface_field.h"
#include "growth/surface/surface_lookup.h"

namespace rinceau {

/// About an element the field has the angle (turns * way + n * direction) / n, `way` being the angle of the ray from it.
enum class FieldElementKind : unsigned char {
    regular,       ///< leads the field its way; no singular point; every n
    wedge,         ///< n = 2, index 1/2
    trisector,     ///< n = 2, index -1/2
    node,          ///< n = 2, index 1: along the rays
    centre,        ///< n = 1 or 2, index 1: round about
    saddle,        ///< n = 1 or 2, index -1
    source,        ///< n = 1, index 1: away
    sink,          ///< n = 1, index 1: towards
    quarter,       ///< n = 4, index 1/4, as at the corner of a box
    minus_quarter  ///< n = 4, index -1/4
};

struct FieldElement {
    FieldElementKind kind = FieldElementKind::regular;
    int vertex = 0;
    /// Radians in the vertex's frame; turns the whole element, and gives a regular one its way.
    double direction = 0;
    double turn = 0;     ///< radians; turns what it says by this everywhere: a node or source becomes a spiral
    double weight = 1;   ///< above 0
    double decay = 3;    ///< per diagonal of the surface: its influence at the distance r is exp(-decay r / diagonal) ..
    bool gauss = false;  ///< .. or exp(-(decay r / diagonal)^2)
};

/// "wedge", "trisector" ...; "center" is centre. None for other names.
std::optional<FieldElementKind> field_element_kind(std::string_view name);
/// The name as it is written.
std::string_view name_of(FieldElementKind kind);
/// All kinds in the order above that a field of n has.
std::vector<FieldElementKind> field_element_kinds(int n);

/// The angle in the frame of `vertex` of a vector in space, seen along the normal there.
double direction_at_vertex(const SurfaceMesh& surface, int vertex, SpacePoint vector);
/// The angle 0 of designs, in the frame of `vertex`: the way of +x, or of +y where the surface faces +x or -x.
double reference_direction(const SurfaceMesh& surface, int vertex);

/// The sum of all elements by their influence, carried over the surface through polar maps. At a singular element's own
/// vertex the field is weak but not 0, as walks would stick there. Vertices that no element reaches have the value 0. Throws
/// InputError in the name of `label` if there is no element, or one is not of fields of this n, has a vertex that the
/// surface has not, or a weight or decay that is not a positive finite number.
SurfaceField field_of_elements(const SurfaceMesh& surface, int n, const std::vector<FieldElement>& elements,
                               const std::string& label, const Progress& progress = {});

}  // namespace rinceau
