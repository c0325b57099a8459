#pragma once
// Who gets how much of the window.

#include "editor/model/shell_state.h"

namespace rinceau {

/// Lengths in window coordinates; 0 = it is not shown. Columns and rows have splitters of `splitter` between them.
struct WindowLayout {
    float left = 0;
    float canvas = 0;
    float right = 0;
    float body = 0;  ///< height of the three columns
    float log = 0;
    float splitter = 0;
    float terminals = 0;  ///< height of what is below the section's heading
    float analysis = 0;
};

/// What is free for columns and log.
struct FreeRoom {
    float width = 0;
    float height = 0;
    float heading = 0;  ///< height of a section's heading
    float scale = 1;    ///< of fonts and widgets
};

/// The sizes that are wished for, as far as there is room: the canvas keeps a third of the width, and half of the height.
/// Neither sum exceeds the room.
WindowLayout window_layout(const ShellState& shell, const FreeRoom& room);

}  // namespace rinceau
