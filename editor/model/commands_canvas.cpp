// Commands of the menu View that concern the canvas, and of selecting on it.

#include "editor/model/command.h"
#include "editor/model/growth_view.h"

namespace rinceau {
namespace {

constexpr double zoom_a_step = 1.25;

Action zoom(const EditorState& state, double factor) { return CanvasAction{ZoomView{0.5 * state.canvas.view.size, factor}}; }

Action toggled(const EditorState& state, OnionMode mode) {
    return CanvasAction{ShowOnion{state.canvas.onion == mode ? OnionMode::off : mode}};
}

/// What is being painted or grown, the brush, what has grown: one at a time.
std::optional<GrowthAction> growth_to_cancel(const EditorState& state) {
    const GrowthState& growth = state.growth;
    if (!growth.stroke.empty()) return DropStroke{};
    if (growth.work != GrowthWork::none || !growth.waiting.empty() || growth.fill_waits) return StopGrowth{};
    if (brush_on_canvas(state) != GrowthBrush::none) return TakeBrush{GrowthBrush::none};
    if (growth_is_open(state) && shows_grown(state)) return DropGrowth{};
    return std::nullopt;
}

Action cancel(const EditorState& state) {
    if (state.canvas.drag) return CanvasAction{DropHandle{}};
    if (state.preview) return RulesAction{DropPreview{}};
    if (const auto growth = growth_to_cancel(state)) return *growth;
    return CanvasAction{ClearSelection{}};
}

bool has_picture(const EditorState& state) { return state.picture != nullptr && !state.picture->items.empty(); }
bool has_selection(const EditorState& state) { return state.canvas.selection.has_value(); }

std::vector<Command> view_commands() {
    return {
        {.name = "view.fit",
         .menu = "View",
         .label = "Fit",
         .shortcut = "0",
         .help = "Shows the whole picture.",
         .action = [](const EditorState&) -> Action { return CanvasAction{FitView{}}; }},
        {.name = "view.zoom_in",
         .menu = "View",
         .label = "Zoom in",
         .shortcut = "+",
         .help = "Shows the middle of the canvas larger. The wheel zooms to the mouse.",
         .action = [](const EditorState& state) -> Action { return zoom(state, zoom_a_step); }},
        {.name = "view.zoom_out",
         .menu = "View",
         .label = "Zoom out",
         .shortcut = "-",
         .help = "Shows more of the picture.",
         .action = [](const EditorState& state) -> Action { return zoom(state, 1 / zoom_a_step); }},
        {.name = "view.actual_size",
         .menu = "View",
         .label = "100 %",
         .shortcut = "1",
         .help = "Shows a unit of the drawing as a pixel.",
         .action = [](const EditorState&) -> Action { return CanvasAction{ActualSize{}}; }},
        {.name = "view.zoom_to_selection",
         .menu = "View",
         .label = "Zoom to selection",
         .shortcut = "2",
         .help = "Shows what is selected as large as the canvas.",
         .enabled = has_selection,
         .action = [](const EditorState&) -> Action { return CanvasAction{ZoomToSelection{}}; }},
        {.name = "view.before_and_after",
         .menu = "View",
         .label = "Before and after",
         .shortcut = "B",
         .help = "Lays the drawing as it was opened over what it is now, as a trace. Again: off.",
         .enabled = has_picture,
         .action = [](const EditorState& state) -> Action { return toggled(state, OnionMode::before_and_after); }},
        {.name = "view.difference",
         .menu = "View",
         .label = "Difference",
         .shortcut = "D",
         .help = "Marks what looks different from the drawing as it was opened. Again: off.",
         .enabled = has_picture,
         .action = [](const EditorState& state) -> Action { return toggled(state, OnionMode::difference); }},
    };
}

}  // namespace

std::vector<Command> canvas_commands() {
    std::vector<Command> commands = view_commands();
    const std::vector<Command> selecting = {
        {.name = "select.up",
         .menu = "Select",
         .label = "Level above",
         .shortcut = "[",
         .help = "From the element towards the axiom: the row it stands in, what that stands in. So does a second click.",
         .enabled = has_selection,
         .action = [](const EditorState&) -> Action { return CanvasAction{StepSelection{-1}}; }},
        {.name = "select.down",
         .menu = "Select",
         .label = "Level below",
         .shortcut = "]",
         .help = "Back towards the element that was clicked. So does a double click.",
         .enabled = has_selection,
         .action = [](const EditorState&) -> Action { return CanvasAction{StepSelection{1}}; }},
        {.name = "select.next",
         .menu = "Select",
         .label = "Next",
         .shortcut = ".",
         .help = "The next element, row or group, in order of derivation; the first, if nothing is selected.",
         .enabled = has_picture,
         .action = [](const EditorState&) -> Action { return CanvasAction{SelectNeighbour{true}}; }},
        {.name = "select.previous",
         .menu = "Select",
         .label = "Previous",
         .shortcut = ",",
         .help = "The element, row or group before.",
         .enabled = has_picture,
         .action = [](const EditorState&) -> Action { return CanvasAction{SelectNeighbour{false}}; }},
        {.name = "select.erase",
         .menu = "Select",
         .label = "Erase",
         .shortcut = "Delete",
         .help = "Takes away what is selected, here alone: an exception to the rules.",
         .enabled = has_selection,
         .action = [](const EditorState&) -> Action { return CanvasAction{EraseSelected{}}; }},
        {.name = "select.none",
         .menu = "Select",
         .label = "Nothing",
         .shortcut = "Escape",
         .help = "Drops what is being dragged or has grown; else nothing is selected any more.",
         .action = cancel},
    };
    commands.insert(commands.end(), selecting.begin(), selecting.end());
    return commands;
}

}  // namespace rinceau
