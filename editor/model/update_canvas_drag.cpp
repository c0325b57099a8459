// Dragging handles on the canvas.

#include <cmath>

#include "editor/model/update_canvas.h"
#include "lsystem/numbers.h"
#include "lsystem/set_numbers.h"

namespace rinceau {
namespace {

/// What is previewed is taken back; the handle stays held.
void show_unchanged(Update& update) {
    update.state.canvas.drag->told.clear();
    if (update.state.preview) perform(update, RulesAction{DropPreview{}});
}

void drag_count(Update& update, HandleDrag& drag, bool only_here) {
    const CanvasHandle& handle = drag.handle;
    const int count = dragged_count(handle.track, drag.to - (drag.from - handle.at), drag.turned);
    if (count == handle.track.count) {
        show_unchanged(update);
        return;
    }
    const std::string& name = only_here && !handle.own_number.empty() ? handle.own_number : handle.numbers.front();
    const NumberEdit edit{.name = name, .value = number_expression(count)};
    drag.told = name + ' ' + std::to_string(handle.track.count) + " -> " + std::to_string(count);
    preview_grammar(update, "set " + name, [&](const Grammar& grammar) { return set_numbers(grammar, {&edit, 1}); });
}

}  // namespace

void drag_on_canvas(Update& update, const GrabHandle& action) {
    CanvasState& canvas = update.state.canvas;
    if (canvas.drag || !canvas.selection || action.index >= canvas.handles.size()) return;
    canvas.drag = HandleDrag{canvas.handles[action.index], action.at, action.at, 0, *canvas.selection, {}};
}

void drag_on_canvas(Update& update, const DragHandle& action) {
    if (!update.state.canvas.drag) return;
    HandleDrag& drag = *update.state.canvas.drag;
    const Point center = drag.handle.track.center;
    drag.turned += wrap_angle(arg(action.to - center) - arg(drag.to - center));
    drag.to = action.to;
    drag_count(update, drag, action.only_here);
}

void drag_on_canvas(Update& update, const ReleaseHandle&) {
    if (!update.state.canvas.drag) return;
    const bool changed = update.state.preview.has_value();
    update.state.canvas.drag.reset();
    if (changed) {
        perform(update, RulesAction{CommitPreview{}});
    } else {
        follow_selection(update);
    }
}

void drag_on_canvas(Update& update, const DropHandle&) {
    CanvasState& canvas = update.state.canvas;
    if (!canvas.drag) return;
    canvas.selection = canvas.drag->before;
    canvas.drag.reset();
    if (update.state.preview) {
        perform(update, RulesAction{DropPreview{}});
    } else {
        follow_selection(update);
    }
}

}  // namespace rinceau
