#pragma once
// The drawing in normal form (NORMAL_FORM.md): a flat list of elements in paint order.

#include <string>
#include <vector>

#include "geometry/box.h"
#include "scene/path.h"
#include "scene/style.h"

namespace rinceau {

/// One drawn thing. Either an outline (`paths` with `style`), or, when `verbatim` is not empty, a piece of SVG that is
/// kept as it is and drawn back in its place (text, images, filters, cutting clips, ...).
struct Element {
    std::vector<Path> paths;
    Style style;
    std::string id;  ///< the id in the drawing, may be empty
    /// A self-contained SVG fragment (with the definitions that it uses) in SVG's own space: y down, user units of the scene.
    std::string verbatim;
    Box verbatim_box;  ///< scene space: where the fragment may draw, if known; empty = unknown, may draw anywhere
};

/// Scene space: x right, y UP, unit = px (1/96 inch); scene y = -(SVG y) of the outermost viewport after its viewBox.
struct Scene {
    Box viewport;       ///< what the picture shows
    bool sized = true;  ///< false: the drawing had neither size nor viewBox, and writes none
    std::vector<Element> elements;  ///< paint order, lowest first
};

/// The box of what an element paints: outline grown by its stroke (mitres included); a verbatim element's box.
Box painted_box(const Element& element);

/// The length that shares of the drawing's diagonal refer to: of the viewport; of what is painted, if the viewport is empty;
/// 1 if that is nothing or a point.
double drawing_diagonal(const Scene& scene);

}  // namespace rinceau
