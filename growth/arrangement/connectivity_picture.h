#pragma once
// The connectivity of an exemplar, drawn: for a person who wants to see what growth copies, and which edges to flip.

#include "growth/arrangement/exemplar.h"
#include "scene/element.h"

namespace rinceau {

/// Outlines in grey; edges as lines; an element that may be chosen has a filled disc, others a ring, in a colour by their
/// kind; beside each original its number, as `flips` of ExemplarOptions counts them, drawn with lines, since a scene has no
/// letters. Of a tiled exemplar the originals, their edges, and the tile as a frame. The viewport is the box of all that.
Scene connectivity_picture(const Exemplar& exemplar);

}  // namespace rinceau
