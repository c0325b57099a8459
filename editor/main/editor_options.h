#pragma once
// The command line of the editor.

#include <string>

namespace rinceau {

struct EditorOptions {
    std::string file;        ///< to open; empty = none
    std::string screenshot;  ///< draw one frame into this PNG and leave
    int width = 1280;        ///< of the window, in screen coordinates
    int height = 800;
    std::string places;  ///< write the places of all widgets here after each frame (tests)
};

}  // namespace rinceau
