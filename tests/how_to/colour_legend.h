#pragma once
// The colours of a picture. With legend_panel.h the worked example of docs/how_to/editor_panel.md.

#include <vector>

#include "editor/model/derived_picture.h"
#include "editor/model/lit_items.h"
#include "scene/style.h"

namespace rinceau {

struct LegendColour {
    Color color;
    std::size_t elements = 0;  ///< that are filled or stroked with it
};

/// Plain colours that elements of the picture are painted with, the most frequent first, equal ones by red, green and blue.
/// Gradients and fragments of SVG have none. Time: linear in the elements.
std::vector<LegendColour> colour_legend(const DerivedPicture& picture);

/// The elements that a colour is used for.
LitItems lit_by_colour(const DerivedPicture& picture, Color color);

}  // namespace rinceau
