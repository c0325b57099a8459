#pragma once
// What is looked at, and what is selected.

#include <optional>
#include <vector>

#include "editor/model/handle_edit.h"
#include "editor/model/lit_items.h"
#include "editor/model/selection.h"
#include "editor/model/view_transform.h"

namespace rinceau {

struct CanvasState {
    ViewTransform view;
    bool fit_pending = true;  ///< the next picture is fitted into the canvas
    std::optional<Selection> selection;
    std::vector<CanvasHandle> handles;  ///< of the selection
    std::optional<HandleDrag> drag;

    int hovered_item = -1;         ///< order of the element under the mouse
    int hovered_production = no_production;  ///< whose elements are lit; -1 = the axiom
    int hovered_terminal = -1;     ///< whose elements are lit; -1 = none
    LitItems lit;                  ///< null = nothing fades
    LitItems outlined;             ///< of the selection

    OnionMode onion = OnionMode::off;
    std::shared_ptr<const DerivedPicture> before;  ///< of the drawing as it was opened, while onion is not off
};

}  // namespace rinceau
