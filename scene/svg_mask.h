#pragma once
// Masks that are plain: white shapes through which all is seen, which is what drawing programs write for a frame.

#include "scene/svg_reader.h"

namespace rinceau {

enum class MaskResult : std::uint8_t {
    applied,  ///< the elements are what the mask leaves of them
    absent,   ///< the mask does not exist; nothing is masked then
    unknown   ///< the mask is more than a plain one: nothing has been done
};

/// Applies the mask of `context` to the elements from `first` on if it is made of opaque white shapes without strokes (of
/// any colour if it masks by alpha): it is a clip then, and dropped where it cuts nothing.
MaskResult apply_mask(SvgReader& reader, const SvgContext& context, std::size_t first);

}  // namespace rinceau
