#pragma once
// How much a drawing draws once every use is expanded: known before anything is drawn.

#include <cstddef>

#include "scene/svg_reader.h"

namespace rinceau {

/// An upper estimate of the number of drawn elements (markers not counted).
/// Throws LimitError if it exceeds max_elements, or if elements and references are nested deeper than max_depth.
std::size_t expanded_elements(const SvgReader& reader);

}  // namespace rinceau
