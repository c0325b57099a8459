// Selecting on the canvas.

#include <algorithm>

#include "editor/model/elements_at.h"
#include "editor/model/hit_test.h"
#include "editor/model/update_canvas.h"

namespace rinceau {
namespace {

constexpr std::size_t most_below = 100;  ///< elements of a heap that are clicked through

void search(Update& update, int clicked, std::size_t level = deepest_level) {
    EditorState& state = update.state;
    if (!state.picture) return;
    const CanvasState& canvas = state.canvas;
    update.requests.push_back(
        FindSelection{{state.picture_revision, shown_document(state), state.picture,
                       canvas.drag ? canvas.drag->before : canvas.selection, clicked, level, !canvas.drag.has_value()}});
}

void select_level(Update& update, std::size_t level) {
    EditorState& state = update.state;
    state.canvas.selection->level = level;
    search(update, -1);
}

/// Under the selected one; under all of them comes the uppermost again.
std::optional<std::int32_t> element_below(const EditorState& state, const ClickCanvas& action) {
    const std::vector<int> found = elements_at(*state.picture, action.at, action.reach, most_below);
    if (found.empty()) return std::nullopt;
    if (!state.canvas.selection) return found.front();
    const auto last = std::ranges::find(found, selected_element(*state.canvas.selection));
    return last == found.end() || last + 1 == found.end() ? found.front() : *(last + 1);
}

}  // namespace

void select_on_canvas(Update& update, const ClickCanvas& action) {
    const EditorState& state = update.state;
    if (!state.picture || state.canvas.drag) return;
    const auto clicked = action.below ? element_below(state, action) : HitIndex(state.picture).item_at(action.at, action.reach);
    if (clicked) {
        search(update, *clicked);
    } else {
        select_on_canvas(update, ClearSelection{});
    }
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

void select_on_canvas(Update& update, const SelectNeighbour& action) {
    const EditorState& state = update.state;
    if (!state.picture || state.picture->items.empty() || state.canvas.drag) return;
    if (!state.canvas.selection) {
        search(update, 0);
        return;
    }
    const PathModule& here = selected_module(*state.canvas.selection);
    const auto elements = static_cast<int>(state.picture->items.size());
    const int wanted = action.next ? here.last : here.first - 1;
    search(update, (wanted + elements) % elements, state.canvas.selection->level);
}

void select_on_canvas(Update& update, const ClearSelection&) {
    CanvasState& canvas = update.state.canvas;
    canvas.selection.reset();
    canvas.handles.clear();
    canvas.outlined.reset();
}

void select_on_canvas(Update& update, const SelectionFound& action) {
    EditorState& state = update.state;
    if (action.revision != state.picture_revision) return;
    if (!action.selection) {
        select_on_canvas(update, ClearSelection{});
        return;
    }
    state.canvas.selection = action.selection;
    const PathModule& module = selected_module(*action.selection);
    state.canvas.outlined = lit_range(state.picture->items.size(), module.first, module.last);
    if (!state.canvas.drag) state.canvas.handles = action.handles;
}

void follow_selection(Update& update) {
    if (update.state.canvas.selection) search(update, -1);
}

}  // namespace rinceau
