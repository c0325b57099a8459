// Commands of the menu Growth.

#include "editor/model/command.h"
#include "editor/model/growth_view.h"

namespace rinceau {
namespace {

constexpr const char* menu_growth = "Growth";
constexpr const char* menu_brush = "Growth/Brush";

bool has_elements(const EditorState& state) { return !state.document.resolved->terminals.empty(); }
bool works(const EditorState& state) {
    return state.growth.work != GrowthWork::none || !state.growth.waiting.empty() || state.growth.fill_waits;
}
bool may_use(const EditorState& state) { return has_grown(state) && state.growth.work == GrowthWork::none; }

template <GrowthBrush brush>
Command brush_command(const std::string& name, const std::string& label, const std::string& help) {
    return {.name = "growth." + name,
            .menu = menu_brush,
            .label = label,
            .help = help,
            .enabled = has_elements,
            .action = [](const EditorState&) -> Action { return GrowthAction{TakeBrush{brush}}; },
            .checked = [](const EditorState& state) { return brush_on_canvas(state) == brush; }};
}

template <GrowthBrush brush, bool all>
Command erase_command(const std::string& name, const std::string& label, const std::string& help) {
    return {.name = "growth." + name,
            .menu = menu_brush,
            .label = label,
            .help = help,
            .enabled =
                [](const EditorState& state) {
                    const GuideLines& guides = *state.growth.guides;
                    return !(brush == GrowthBrush::flow ? guides.flow : guides.boundary).empty();
                },
            .action = [](const EditorState&) -> Action {
                return GrowthAction{EraseStrokes{brush, all}};
            }};
}

std::vector<Command> growing_commands() {
    return {
        {.name = "growth.begin",
         .menu = menu_growth,
         .label = "Grow an arrangement",
         .shortcut = "Ctrl+G",
         .help = "More elements that stand to each other as those of the drawing do: anew, by the settings of the panel.",
         .enabled = has_elements,
         .action = [](const EditorState&) -> Action { return GrowthAction{BeginGrowth{}}; }},
        {.name = "growth.more",
         .menu = menu_growth,
         .label = "Grow on",
         .shortcut = "Ctrl+Shift+G",
         .help = "As many elements more beside what has grown.",
         .enabled = has_elements,
         .action = [](const EditorState&) -> Action { return GrowthAction{GrowMore{}}; }},
        {.name = "growth.relax",
         .menu = menu_growth,
         .label = "Relax",
         .help = "Moves what has grown so that neighbours stand as in the drawing, as nearly as they can.",
         .enabled = has_arrangement,
         .action = [](const EditorState&) -> Action { return GrowthAction{FinishGrowth{false}}; }},
        {.name = "growth.finish",
         .menu = menu_growth,
         .label = "Finish",
         .help = "Relaxes what has grown, fills its gaps and takes overlaps away.",
         .enabled = has_arrangement,
         .action = [](const EditorState&) -> Action { return GrowthAction{FinishGrowth{true}}; }},
        {.name = "growth.fill",
         .menu = menu_growth,
         .label = "Fill an aggregate",
         .shortcut = "Ctrl+Alt+G",
         .help =
             "Packs the shapes of the drawing densely, without overlaps and without a period, by the settings of the panel.",
         .enabled = has_elements,
         .action = [](const EditorState&) -> Action { return GrowthAction{FillAggregate{}}; }},
        {.name = "growth.other_seed",
         .menu = menu_growth,
         .label = "Another one",
         .help = "The next seed: the same settings, other draws.",
         .enabled = has_elements,
         .action = [](const EditorState&) -> Action { return GrowthAction{GrowOtherSeed{}}; }},
        {.name = "growth.stop",
         .menu = menu_growth,
         .label = "Stop growing",
         .help = "What has grown until now stays; so does Esc.",
         .enabled = works,
         .action = [](const EditorState&) -> Action { return GrowthAction{StopGrowth{}}; }},
    };
}

std::vector<Command> result_commands() {
    return {
        {.name = "growth.use",
         .menu = menu_growth,
         .label = "Use as drawing",
         .shortcut = "Ctrl+Shift+U",
         .help = "What has grown becomes the drawing, with rules that draw it: one edit, which Undo takes back.",
         .enabled = may_use,
         .action = [](const EditorState&) -> Action { return GrowthAction{UseGrowth{}}; }},
        {.name = "growth.show",
         .menu = menu_growth,
         .label = "Show what has grown",
         .help = "Switches between what has grown and the drawing.",
         .enabled = [](const EditorState& state) { return state.growth.grown != nullptr; },
         .action = [](const EditorState& state) -> Action { return GrowthAction{ShowGrowth{!shows_grown(state)}}; },
         .checked = shows_grown},
        {.name = "growth.drop",
         .menu = menu_growth,
         .label = "Clear what has grown",
         .help = "Back to the drawing, which has not changed.",
         .enabled = [](const EditorState& state) { return state.growth.grown != nullptr; },
         .action = [](const EditorState&) -> Action { return GrowthAction{DropGrowth{}}; }},
        {.name = "growth.bring_back",
         .menu = menu_growth,
         .label = "Bring back what was cleared",
         .help = "What had grown before it was cleared, used or begun anew.",
         .enabled = [](const EditorState& state) { return state.growth.dropped != nullptr; },
         .action = [](const EditorState&) -> Action { return GrowthAction{BringBackGrowth{}}; }},
        {.name = "growth.edges",
         .menu = menu_growth,
         .label = "Neighbours",
         .help = "Draws lines between elements that are neighbours.",
         .action = [](const EditorState& state) -> Action {
             GrowthSettings settings = state.growth.settings;
             settings.edges = !settings.edges;
             return GrowthAction{SetGrowth{std::move(settings)}};
         },
         .checked = [](const EditorState& state) { return state.growth.settings.edges; }},
    };
}

std::vector<Command> brush_commands() {
    return {
        brush_command<GrowthBrush::spray>("spray", "Spray", "Elements grow where the left mouse button is dragged."),
        brush_command<GrowthBrush::flow>("flow", "Flow strokes",
                                         "Lines drawn on the canvas turn the elements that grow along them."),
        brush_command<GrowthBrush::boundary>("boundary", "Boundary strokes",
                                             "Nothing grows across lines drawn on the canvas."),
        brush_command<GrowthBrush::flip>("flip", "Flip edges",
                                         "A click on a line between two neighbours joins the other two of their four."),
        erase_command<GrowthBrush::flow, false>("erase_flow", "Erase the last flow stroke",
                                                "The flow is as it was before it."),
        erase_command<GrowthBrush::flow, true>("erase_flows", "Erase all flow strokes", "There is no flow any more."),
        erase_command<GrowthBrush::boundary, false>("erase_boundary", "Erase the last boundary stroke",
                                                    "The boundary is as it was before it."),
        erase_command<GrowthBrush::boundary, true>("erase_boundaries", "Erase all boundary strokes",
                                                   "There is no boundary any more."),
        {.name = "growth.forget_flips",
         .menu = menu_brush,
         .label = "Forget flipped edges",
         .help = "Neighbours are as they were found in the drawing.",
         .enabled = [](const EditorState& state) { return !state.growth.flips.empty(); },
         .action = [](const EditorState&) -> Action { return GrowthAction{ForgetFlips{}}; }},
    };
}

}  // namespace

std::vector<Command> growth_commands() {
    std::vector<Command> all;
    all.push_back({.name = "growth.arrangement",
                   .menu = menu_growth,
                   .label = "Arrangement..",
                   .help = "Shows the panel: more of the same, by example.",
                   .action = [](const EditorState&) -> Action { return GrowthAction{OpenGrowth{GrowthTab::arrangement}}; }});
    all.push_back({.name = "growth.aggregate",
                   .menu = menu_growth,
                   .label = "Aggregate..",
                   .help = "Shows the panel: shapes packed densely.",
                   .action = [](const EditorState&) -> Action { return GrowthAction{OpenGrowth{GrowthTab::aggregate}}; }});
    for (const auto part : {growing_commands, result_commands, brush_commands})
        for (Command& command : part()) all.push_back(std::move(command));
    return all;
}

}  // namespace rinceau
