#pragma once
// What is looked at, and what is selected.

#include "editor/model/view_transform.h"

namespace rinceau {

struct CanvasState {
    ViewTransform view;
    bool fit_pending = true;  ///< the next picture is fitted into the canvas
};

}  // namespace rinceau
