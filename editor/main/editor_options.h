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
    bool light = false;           ///< dark letters on a light ground, whatever the preferences say
    double autosave_seconds = 0;  ///< between two copies for emergencies; 0 = as preferred
    std::string places;       ///< write what the window shows (model/places_json.h) here after each frame; empty = nowhere
    std::string picture;      ///< draw the canvas's picture alone into this PNG and leave; empty = do not
    int picture_width = 900;  ///< of that picture, in pixels
    bool as_drawing = false;  ///< in that picture an SVG is drawn as it was read, not as it was analysed
};

}  // namespace rinceau
