// Selecting on the canvas.

#include <algorithm>

#include "editor/model/picture_boxes.h"
#include "editor/model/update_canvas.h"

namespace rinceau {
namespace {

/// Orders of the elements whose box the point is in, the uppermost first.
std::vector<int> elements_at(const DerivedPicture& picture, Point at, double reach) {
    const PictureBoxes boxes(picture);
    std::vector<int> found;
    for (auto item = picture.items.rbegin(); item != picture.items.rend(); ++item) {
        const Box& box = boxes.own_box(item->order);
        if (is_empty(box)) continue;
        const Point own = apply(inverse(item->pose), at);
        const Box reached = grown(box, reach / scale_of(item->pose));
        if (contains(reached, Box{own, own})) found.push_back(item->order);
    }
    return found;
}

void search(Update& update, int clicked) {
    EditorState& state = update.state;
    if (!state.picture) return;
    const CanvasState& canvas = state.canvas;
    update.requests.push_back(FindSelection{{state.picture_revision, shown_document(state), state.picture,
                                             canvas.drag ? canvas.drag->before : canvas.selection, clicked,
                                             !canvas.drag.has_value()}});
}

void select_level(Update& update, std::size_t level) {
    EditorState& state = update.state;
    state.canvas.selection->level = level;
    search(update, -1);
}

}  // namespace

void select_on_canvas(Update& update, const ClickCanvas& action) {
    const EditorState& state = update.state;
    if (!state.picture || state.canvas.drag) return;
    const std::vector<int> found = elements_at(*state.picture, action.at, action.reach);
    if (found.empty()) {
        select_on_canvas(update, ClearSelection{});
        return;
    }
    auto clicked = found.begin();
    if (action.below && state.canvas.selection) {
        const auto last = std::ranges::find(found, selected_element(*state.canvas.selection));
        if (last != found.end()) clicked = last + 1;
        if (clicked == found.end()) clicked = found.begin();
    }
    search(update, *clicked);
}

void select_on_canvas(Update& update, const SelectLevel& action) {
    const auto& selection = update.state.canvas.selection;
    if (!selection || action.level >= selection->path.size()) return;
    select_level(update, action.level);
}

void select_on_canvas(Update& update, const StepSelection& action) {
    const auto& selection = update.state.canvas.selection;
    if (!selection) return;
    const std::vector<std::size_t> levels = shown_levels(*selection);
    const auto here = std::ranges::lower_bound(levels, selection->level) - levels.begin();
    const auto last = static_cast<std::ptrdiff_t>(levels.size()) - 1;
    const auto wanted = std::clamp<std::ptrdiff_t>(here + action.levels, 0, last);
    select_level(update, levels[static_cast<std::size_t>(wanted)]);
}

void select_on_canvas(Update& update, const ClearSelection&) {
    update.state.canvas.selection.reset();
    update.state.canvas.handles.clear();
}

void select_on_canvas(Update& update, const SelectionFound& action) {
    EditorState& state = update.state;
    if (action.revision != state.picture_revision) return;
    state.canvas.selection = action.selection;
    if (!state.canvas.drag) state.canvas.handles = action.handles;
}

void follow_selection(Update& update) {
    if (update.state.canvas.selection) search(update, -1);
}

}  // namespace rinceau
