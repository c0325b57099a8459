#pragma once
// The window for choosing a sample or a recent file.

#include "editor/panels/panel.h"

namespace rinceau {

/// Draws it if there is a list in the state.
Actions pick_list_window(const EditorState& state, const PanelTools& tools);

}  // namespace rinceau
