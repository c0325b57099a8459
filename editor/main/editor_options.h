#pragma once
// The command line of the editor.

#include <string>

namespace rinceau {

struct EditorOptions {
    std::string file;  ///< to open; empty = none
    std::string
        screenshot;    ///< draw the window into this PNG when all work is done, and leave; empty = a window for a person
    int width = 1280;  ///< of the window; of a screenshot, in pixels
    int height = 800;
    float scale = 0;              ///< of fonts and widgets; 0 = the display's
    double autosave_seconds = 0;  ///< between two copies for emergencies; 0 = as preferred
    std::string places;  ///< write what the window shows (model/places_json.h) here after each frame; empty = nowhere
};

}  // namespace rinceau
