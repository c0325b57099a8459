#pragma once
// Fields and their designs as JSON text.
//
// A field: {"n": 2, "vectors": [[x, y, z], ..]} by vertex in space, of the length of its strength (of a line field or a
// cross any of its ways), or {"n": 2, "z": [[re, im], ..], "frame": "edge"} in the frames of the vertices, whose x axis is
// the first edge counter-clockwise from the border or the first in the file. Besides or instead: "isotropic": [..], half the
// traces of tensors, and "scalar": [..], numbers. A design: {"n": 2, "elements": [{"type": "wedge", "vertex": 5}, ..],
// "smooth": 0.03, "rounds": 0}, or the list alone. An element has "type", and "vertex" or "at": [x, y, z] (the nearest
// vertex); it may have "direction": [x, y, z] or "angle" (degrees from the way of +x), "turn" (degrees), "weight", "decay"
// and "fall": "exp" or "gauss".

#include <string>
#include <string_view>

#include "growth/surface/field_elements.h"

namespace rinceau {

/// Which frame the written values are in.
enum class FieldFrame : unsigned char { space, edge };

/// Throws InputError in the name of `label`, with the place in the document: for text that is no JSON, keys that it does not
/// know, lists of another length than the surface's vertices, and whatever FieldOnSurface refuses. A file with numbers alone
/// gets their gradient as its directions (n = 1).
SurfaceField read_field_json(std::string_view text, const SurfaceMesh& surface, const std::string& label);

/// Reads back to the same field: in the frame of edges to the bit, in space to rounding. Closed forms are written as values.
std::string field_json(const SurfaceField& field, const SurfaceMesh& surface, FieldFrame frame);

struct FieldDesign {
    int n = 2;
    std::vector<FieldElement> elements;
    double smooth = 0;  ///< diagonals, of one implicit step
    int rounds = 0;     ///< of local smoothing
};

/// Throws InputError as read_field_json() does.
FieldDesign read_field_design_json(std::string_view text, const SurfaceMesh& surface, const std::string& label);

}  // namespace rinceau
