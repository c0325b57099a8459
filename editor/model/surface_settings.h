#pragma once
// What is set for growth on a surface. In words of its own: what the panels include does not change with the library.

#include <cstdint>
#include <string>
#include <vector>

#include "growth/mesh/triangle_mesh.h"

namespace rinceau {

/// What the left mouse button does on a surface.
enum class SurfaceTool : unsigned char { turn, element, seed };

/// What the directions of the field are.
enum class FieldSymmetry : unsigned char { vectors, lines, crosses };

/// Something put on the surface by hand: a design element of the field, or a seed where an axiom begins.
struct SurfaceMark {
    std::string kind;  ///< of an element: regular, wedge, trisector, node, centre, saddle; empty for a seed
    SpacePoint at;     ///< on the surface
    double angle = 0;  ///< degrees, counter-clockwise from the surface's own direction there
    friend bool operator==(const SurfaceMark&, const SurfaceMark&) = default;
};

/// The field that guides growth.
struct FieldSettings {
    enum class Source : unsigned char { none, elements, curvature, smoothest };
    Source source = Source::none;
    FieldSymmetry symmetry = FieldSymmetry::lines;
    std::vector<SurfaceMark> elements;
    double decay = 3;      ///< of an element's pull, a diagonal of the mesh
    double smooth = 0.03;  ///< reach of the smoothing, share of the diagonal; 0 = none
    friend bool operator==(const FieldSettings&, const FieldSettings&) = default;
};

struct SurfaceSettings {
    std::string mesh;     ///< file; empty = none
    std::string grammar;  ///< file of a shape grammar; empty = the document's rules
    FieldSettings field;
    std::string output;              ///< file that what has grown is written to
    std::vector<SurfaceMark> seeds;  ///< where growth begins; none = where the grammar says
    SurfaceTool tool = SurfaceTool::turn;
    std::string element = "regular";  ///< kind of the next element
    bool ground = true, wireframe = false, streamlines = true, singular = true;
    double spacing = 0.02;  ///< of streamlines, share of the diagonal
    double size = 0.5;      ///< of a drawing: its diagonal, share of the surface's
    double heading = 0;     ///< of a drawing: degrees
    double follow = 0.4;    ///< of a drawing: share of the field's turning
    double height = 0;      ///< of a drawing's walls, share of the surface's diagonal
    bool merge = false;     ///< parts of a drawing that meet themselves stay
    int steps = -1;         ///< of a shape grammar: rules to apply; -1 = all
    std::uint64_t seed = 1;
};

}  // namespace rinceau
