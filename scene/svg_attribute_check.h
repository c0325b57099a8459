#pragma once
// Warnings of attributes whose values are not understood, and of properties that change the picture but are not supported.
// The parts of the reader that use an attribute then take its default without a word.

#include "scene/svg_reader.h"

namespace rinceau {

/// Checks the attributes that matter to the picture by the kind of element: lengths, view boxes, aspect ratios, keywords;
/// `specified` are the element's specified values. To be called once for each element that is drawn or referred to.
void check_attributes(SvgReader& reader, const SvgNode& node, const SpecifiedStyle& specified);

}  // namespace rinceau
