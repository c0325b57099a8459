#pragma once
// What selected elements of a document draw, in the space of the place where something else is to be drawn instead.

#include "scene/svg_selection.h"

namespace rinceau {

struct SvgExcerpt {
    Scene scene;  ///< scene space is the user space of the selection's parent, with y up
    std::vector<Warning> warnings;
    /// Drawn elements above a chosen one that it overlaps, and below the uppermost chosen one: they will lie under it.
    std::size_t overtaken = 0;
};

/// Effects of groups that hold only a part of the selection and not the place are not taken along, but for their opacity.
/// `reader` must be as enter_root() leaves it, and is used up. Throws InputError if the place is flattened by its transform.
SvgExcerpt read_excerpt(SvgReader& reader, const SvgContext& root, const SvgSelection& selection);

}  // namespace rinceau
