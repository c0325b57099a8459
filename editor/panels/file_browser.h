#pragma once
// The window for choosing a file.

#include "editor/panels/panel.h"

namespace rinceau {

/// Draws it if there is a dialog in the state.
Actions file_browser(const EditorState& state, const PanelTools& tools);

}  // namespace rinceau
