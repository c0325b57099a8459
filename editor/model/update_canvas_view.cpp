// Which part of the picture is seen, and beside what.

#include "editor/model/picture_boxes.h"
#include "editor/model/update_canvas.h"

namespace rinceau {
namespace {

/// The document as it was opened, as far back as undo goes.
const Document& first_document(const EditorState& state) {
    return state.history.past.empty() ? state.document : state.history.past.front().document;
}

}  // namespace

void show_on_canvas(Update& update, const ShowOnion& action) {
    EditorState& state = update.state;
    state.canvas.onion = action.mode;
    state.canvas.before.reset();
    if (action.mode != OnionMode::off) update.requests.push_back(DeriveBefore{first_document(state)});
}

void show_on_canvas(Update& update, const BeforeDerived& action) {
    if (update.state.canvas.onion != OnionMode::off) update.state.canvas.before = action.picture;
}

void show_on_canvas(Update& update, const ZoomToSelection&) {
    EditorState& state = update.state;
    if (!state.canvas.selection || !state.picture) return;
    const PathModule& module = selected_module(*state.canvas.selection);
    state.canvas.view = fitted_view(state.canvas.view, PictureBoxes(*state.picture).box(module.first, module.last));
    state.canvas.fit_pending = false;
}

void show_on_canvas(Update& update, const ActualSize&) {
    ViewTransform& view = update.state.canvas.view;
    view = zoomed_view(view, 0.5 * view.size, 1 / view.zoom);
}

}  // namespace rinceau
