#pragma once
// What of the canvas's state the renderer has to know.

#include "editor/gl/picture_emphasis.h"
#include "editor/model/canvas_state.h"

namespace rinceau {

inline PictureEmphasis emphasis_of(const CanvasState& canvas) {
    PictureEmphasis emphasis{canvas.lit, canvas.outlined, canvas.before, PictureComparison::none};
    if (!canvas.before) return emphasis;
    if (canvas.onion == OnionMode::before_and_after) emphasis.comparison = PictureComparison::onion;
    if (canvas.onion == OnionMode::difference) emphasis.comparison = PictureComparison::difference;
    return emphasis;
}

}  // namespace rinceau
