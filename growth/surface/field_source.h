#pragma once
// Fields by the words of a grammar or a command line: field F1 = elements "vine.json" smooth = 0.03.

#include <map>
#include <string>
#include <vector>

#include "geometry/progress.h"
#include "growth/surface/named_file.h"
#include "growth/surface/surface_field.h"
#include "scene/input_error.h"

namespace rinceau {

/// What is said of a field. Every kind has the numbers `smooth` (diagonals, one implicit step), then `rounds` (of local
/// smoothing). Angles are degrees.
///   elements "design.json"   elements placed on the surface (field_json.h)
///   file "field.json"        values by vertex (field_json.h)
///   curvature                the surface's curvature tensor
///   image "picture.png"      along the edges of a picture that lies in x and y, as large as fits the surface's box; with
///   its
///                            colours and brightness. blur, sigma: pixels, see PictureEdges; across = 1: across the edges
///   constant                 angle from +x, in the plane; n
///   radial, vortex, spiral   about x, y of the plane; a spiral has angle to the rays; n
///   direction                the vector x, y, z of space, laid into the surface; n
///   smoothest                n
struct FieldSource {
    std::string name;  ///< of the field in its grammar; may be empty
    std::string kind;
    std::string text;  ///< the file's name
    std::map<std::string, double> numbers;
    std::map<std::string, std::string> words;  ///< no kind has any yet
    SourcePlace place;                         ///< for messages
};

/// The kinds, in the order above.
const std::vector<std::string>& field_source_kinds();

/// Throws InputError at the source's place for an unknown kind, settings that the kind has not, and a file's name that is
/// missing or not wanted.
void check_field_source(const FieldSource& source);

/// Throws InputError as check_field_source() and at the source's place for a number that is out of range, and in the file's
/// name for what is wrong with a file.
SurfaceField make_field(const FieldSource& source, const SurfaceMesh& surface, const ReadNamedFile& read,
                        const Progress& progress = {});

}  // namespace rinceau
