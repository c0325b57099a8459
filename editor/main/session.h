#pragma once
// The window's life: input, update, effects, panels, picture, once a frame.

#include "editor/main/editor_options.h"

namespace rinceau {

/// Opens a window and runs until it is closed; for a screenshot, until it is written. Returns the exit status: 0, 1 if no
/// window or file could be opened (the reason is on standard error), 4 if the screenshot could not be written.
int run_editor(const EditorOptions& options);

}  // namespace rinceau
