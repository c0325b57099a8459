// Dragging handles on the canvas, and erasing what is selected.

#include <cmath>

#include "editor/model/handle_edit.h"
#include "editor/model/update_canvas.h"
#include "editor/model/update_rules.h"
#include "lsystem/edit_exception.h"

namespace rinceau {
namespace {

/// What is previewed is taken back; the handle stays held.
void show_unchanged(Update& update) {
    update.state.canvas.drag->told.clear();
    drop_preview(update);
}

std::optional<HandleEdit> edit_of_drag(const EditorState& state) {
    return handle_edit(state.document, *state.canvas.drag, 1 / state.canvas.view.zoom);
}

}  // namespace

void drag_on_canvas(Update& update, const GrabHandle& action) {
    CanvasState& canvas = update.state.canvas;
    if (canvas.drag || update.state.preview || !canvas.selection || action.index >= canvas.handles.size()) return;
    canvas.drag = HandleDrag{canvas.handles[action.index], action.at, action.at, 0, false, *canvas.selection, {}};
}

void drag_on_canvas(Update& update, const DragHandle& action) {
    if (!update.state.canvas.drag) return;
    HandleDrag& drag = *update.state.canvas.drag;
    const Point center = drag.handle.track.center;
    drag.turned += wrap_angle(arg(action.to - center) - arg(drag.to - center));
    drag.to = action.to;
    drag.only_here = action.only_here;
    const auto edit = edit_of_drag(update.state);
    if (!edit) {
        show_unchanged(update);
        return;
    }
    drag.told = edit->told;
    preview_grammar(update, edit->label, edit->make);
}

void drag_on_canvas(Update& update, const ReleaseHandle&) {
    EditorState& state = update.state;
    if (!state.canvas.drag) return;
    const auto edit = state.preview ? edit_of_drag(state) : std::nullopt;
    const auto steps = state.history.past.size();
    state.canvas.drag.reset();
    if (edit) edit_grammar(update, edit->label, edit->make);
    if (state.history.past.size() != steps && !state.preview) return;
    drop_preview(update);
    follow_selection(update);
}

void drag_on_canvas(Update& update, const DropHandle&) {
    CanvasState& canvas = update.state.canvas;
    if (!canvas.drag) return;
    canvas.selection = canvas.drag->before;
    canvas.drag.reset();
    drop_preview(update);
    follow_selection(update);
}

void drag_on_canvas(Update& update, const EraseSelected&) {
    const EditorState& state = update.state;
    if (!state.canvas.selection || state.canvas.drag || state.preview) return;
    const Selection selection = *state.canvas.selection;
    edit_grammar(update, "erase " + selected_module(selection).symbol,
                 [&](const Grammar& grammar) { return erase_instance(grammar, selection.path, selection.level); });
}

}  // namespace rinceau
