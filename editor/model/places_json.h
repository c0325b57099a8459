#pragma once
// What the window shows, for tests and for pictures in the documentation: where each widget stands, and whether work is
// under way.

#include <cstdint>
#include <string>
#include <vector>

namespace rinceau {

/// Where a widget stands, in window coordinates from the window's upper left corner (on X11 these are pixels).
struct WidgetPlace {
    std::string name;  ///< "rules/Row.count", "toolbar/file.save"
    float left = 0, top = 0, right = 0, bottom = 0;
};

/// One frame as it is shown.
struct WindowTrace {
    std::string title;
    std::uint64_t frame = 0;  ///< number of the frame
    bool busy = false;        ///< something is read, derived or analysed, or the next frame is already due
    bool refining = false;    ///< the picture becomes finer by itself
    int width = 0;            ///< of the framebuffer, in pixels
    int height = 0;
    float scale = 1;  ///< by which fonts and widgets are enlarged
    std::vector<WidgetPlace> widgets;
};

/// A JSON object with the members of WindowTrace by their names, `framebuffer` holding [width, height].
std::string to_json(const WindowTrace& trace);

}  // namespace rinceau
