#pragma once
// Effects of an element on all that it draws: clip, opacity, mask, filter, blending.

#include "scene/svg_reader.h"

namespace rinceau {

/// The state before an element is drawn, to which the drawing can be taken back.
struct SvgMark {
    std::size_t elements = 0;
    SvgWarningLog::Mark warnings = 0;
    std::size_t blended = 0;
};
SvgMark mark_of(const SvgReader& reader);

/// Applies the effects of `context` to what it has drawn since `mark`; where that is not possible element by element, takes
/// it back and keeps the element verbatim as a whole.
void finish_effects(SvgReader& reader, const SvgContext& context, const SvgMark& mark);

}  // namespace rinceau
