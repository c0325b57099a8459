// What the mouse points at, here and in other panels, stands out.

#include "editor/model/hit_test.h"
#include "editor/model/update_canvas.h"

namespace rinceau {
namespace {

constexpr std::size_t most_hovered = 10'000;  ///< elements among which one is found in a few milliseconds

void light_rule(Update& update) {
    const EditorState& state = update.state;
    update.requests.push_back(LightRule{state.picture_revision, shown_document(state), state.canvas.hovered_production});
}

void light_terminal(Update& update) {
    const EditorState& state = update.state;
    if (state.picture) update.state.canvas.lit = lit_by_terminal(*state.picture, state.canvas.hovered_terminal);
}

void forget_hover(CanvasState& canvas) {
    canvas.hovered_production = no_production;
    canvas.hovered_terminal = -1;
    canvas.lit.reset();
}

}  // namespace

void show_on_canvas(Update& update, const HoverCanvas& action) {
    EditorState& state = update.state;
    if (!state.picture || state.picture->items.size() > most_hovered) return;
    state.canvas.hovered_item = HitIndex(state.picture).item_at(action.at, action.reach).value_or(-1);
}

void show_on_canvas(Update& update, const LeaveCanvas&) { update.state.canvas.hovered_item = -1; }

void show_on_canvas(Update& update, const HoverRule& action) {
    CanvasState& canvas = update.state.canvas;
    if (action.production == canvas.hovered_production) return;
    forget_hover(canvas);
    canvas.hovered_production = action.production;
    if (action.production != no_production) light_rule(update);
}

void show_on_canvas(Update& update, const HoverTerminal& action) {
    CanvasState& canvas = update.state.canvas;
    if (action.terminal == canvas.hovered_terminal) return;
    forget_hover(canvas);
    canvas.hovered_terminal = action.terminal;
    if (action.terminal >= 0) light_terminal(update);
}

void show_on_canvas(Update& update, const HoverItems& action) {
    forget_hover(update.state.canvas);
    update.state.canvas.lit = action.lit;
}

void show_on_canvas(Update& update, const RuleLit& action) {
    EditorState& state = update.state;
    if (action.revision != state.picture_revision || action.production != state.canvas.hovered_production) return;
    state.canvas.lit = action.lit;
}

void follow_hover(Update& update) {
    CanvasState& canvas = update.state.canvas;
    canvas.hovered_item = -1;
    if (canvas.hovered_production != no_production) {
        light_rule(update);
    } else if (canvas.hovered_terminal >= 0) {
        light_terminal(update);
    } else if (canvas.lit && canvas.lit->size() != update.state.picture->items.size()) {
        canvas.lit.reset();  // it was of other elements
    }
}

}  // namespace rinceau
