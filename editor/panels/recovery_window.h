#pragma once
// The window that offers what can be recovered.

#include "editor/panels/panel.h"

namespace rinceau {

/// Draws it if there is something in the state.
Actions recovery_window(const EditorState& state, const PanelTools& tools);

}  // namespace rinceau
