// Looking: pan, zoom, the picture that was asked for.

#include "editor/model/update_canvas.h"
#include "editor/model/growth_view.h"

namespace rinceau {
namespace {

void fit_if_pending(EditorState& state) {
    const auto& picture = canvas_picture(state);
    if (!state.canvas.fit_pending || !picture || state.canvas.view.size.x <= 1) return;
    const Box& canvas = picture->grammar->canvas;
    if (is_empty(canvas)) return;
    state.canvas.view = fitted_view(state.canvas.view, canvas);
    state.canvas.fit_pending = false;
}

void perform_one(Update& update, const ResizeCanvas& action) {
    update.state.canvas.view.size = action.size;
    fit_if_pending(update.state);
}

void perform_one(Update& update, const FitView&) {
    update.state.canvas.fit_pending = true;
    fit_if_pending(update.state);
}

void perform_one(Update& update, const ZoomView& action) {
    update.state.canvas.view = zoomed_view(update.state.canvas.view, action.at, action.factor);
}

void perform_one(Update& update, const PanView& action) {
    update.state.canvas.view = panned_view(update.state.canvas.view, action.by);
}

void perform_one(Update& update, const PictureDerived& action) {
    EditorState& state = update.state;
    if (action.revision < state.picture_revision) return;
    state.picture = action.picture;
    state.picture_revision = action.revision;
    state.picture_mistake.clear();
    fit_if_pending(state);
    follow_hover(update);
    follow_selection(update);
}

void perform_one(Update& update, const PictureFailed& action) {
    if (action.revision != update.state.revision) return;
    update.state.picture_mistake = action.message;
}

template <class Known>
concept IsHere = requires(Update& update, const Known& known) {
    perform_one(update, known);
};

}  // namespace

void perform(Update& update, const CanvasAction& action) {
    std::visit(
        [&]<class Known>(const Known& known) {
            if constexpr (IsHere<Known>) {
                perform_one(update, known);
            } else if constexpr (requires { show_on_canvas(update, known); }) {
                show_on_canvas(update, known);
            } else if constexpr (requires { select_on_canvas(update, known); }) {
                select_on_canvas(update, known);
            } else {
                drag_on_canvas(update, known);
            }
        },
        action);
}

}  // namespace rinceau
