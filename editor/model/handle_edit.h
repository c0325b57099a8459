#pragma once
// What dragging a handle does to the grammar.

#include <functional>
#include <optional>
#include <string>

#include "editor/model/handles.h"
#include "lsystem/edit_result.h"

namespace rinceau {

/// A handle that is held.
struct HandleDrag {
    CanvasHandle handle;
    Point from;              ///< scene: where it was grabbed ..
    Point to;                ///< .. and is now
    double turned = 0;       ///< radians, counter-clockwise, that the mouse has gone around the centre of a ring
    bool only_here = false;  ///< it changes this one place, not all
    Selection before;        ///< what was selected
    std::string told;        ///< what it does, "Row.count 3 -> 5"; empty = nothing yet
};

struct HandleEdit {
    std::string label;  ///< of the edit: "set Row.count"
    std::string told;   ///< "Row.count 3 -> 5"
    std::function<EditResult(const Grammar&)> make;
};

/// Nothing if the handle is where it was, or cannot follow there. `pixel` is its size in scene units: values are as round
/// as half a pixel allows, and where one number does nearly what two would do, it is changed alone.
std::optional<HandleEdit> handle_edit(const Document& document, const HandleDrag& drag, double pixel);

}  // namespace rinceau
