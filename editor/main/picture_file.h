#pragma once
// The canvas's picture as a file, for comparing what the editor draws with what others draw.

#include "editor/main/editor_options.h"

namespace rinceau {

/// Draws the file's picture as the canvas does, over white and as fine as it gets, into options.picture:
/// options.picture_width pixels wide, showing the canvas of the grammar. An SVG is analysed first unless options.as_drawing
/// is set. Returns the exit status; what is wrong is told on standard error.
int write_picture_file(const EditorOptions& options);

}  // namespace rinceau
