#pragma once
// The window's life: input, update, effects, panels, picture, once a frame.

#include "editor/main/editor_options.h"

namespace rinceau {

/// Opens a window and runs until it is closed. Returns the exit status.
int run_editor(const EditorOptions& options);

}  // namespace rinceau
