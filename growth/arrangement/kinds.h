#pragma once
// Which elements of a drawing may stand for one another. Internal to the folder.

#include <string>
#include <vector>

#include "growth/figures.h"

namespace rinceau {

struct ElementKinds {
    std::vector<int> of_instance;    ///< kind of each instance of the drawing
    std::vector<std::string> names;  ///< by kind
};

/// A figure that is met often is a kind; with it go the figures of the same terminals, or of the same paint and roundness,
/// that are about as large. What is left is sorted by what paints it (fill, stroke, and colours if these are few) and by
/// clearly different sizes, so that 28 different stones are a kind or two; such a kind has the name of its largest figure. A
/// kind whose elements stand in two to four ways, each of which is met again (upright and upside down), is split by them:
/// ".2", ".3" stand behind the name.
ElementKinds element_kinds(const FiguredDrawing& drawing);

}  // namespace rinceau
