#pragma once
// A panel that names the colours of the picture, and shows on the canvas where they are.

#include "editor/panels/panel.h"

namespace rinceau {

/// A row for each colour: a swatch, its name, how many elements it paints. While the mouse is on a row the elements are lit.
/// Places: "legend/#rrggbb".
Actions legend_panel(const EditorState& state, const PanelTools& tools);

}  // namespace rinceau
