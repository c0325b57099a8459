// Commands of the menu Growth for surfaces.

#include "editor/model/command.h"
#include "editor/model/surface_view.h"

namespace rinceau {
namespace {

constexpr const char* menu_surface = "Growth/Surface";

bool has_stage(const EditorState& state) { return state.surface.stage != nullptr; }

template <SurfaceTool tool>
Command tool_command(const std::string& name, const std::string& label, const std::string& help) {
    return {.name = "surface." + name,
            .menu = menu_surface,
            .label = label,
            .help = help,
            .enabled = has_stage,
            .action = [](const EditorState& state) -> Action {
                SurfaceSettings settings = state.surface.settings;
                settings.tool = tool;
                return SurfaceAction{SetSurface{std::move(settings)}};
            },
            .checked = [](const EditorState& state) { return state.surface.settings.tool == tool; }};
}

template <bool SurfaceSettings::*what>
Command show_command(const std::string& name, const std::string& label, const std::string& help) {
    return {.name = "surface." + name,
            .menu = menu_surface,
            .label = label,
            .help = help,
            .action = [](const EditorState& state) -> Action {
                SurfaceSettings settings = state.surface.settings;
                settings.*what = !(settings.*what);
                return SurfaceAction{SetSurface{std::move(settings)}};
            },
            .checked = [](const EditorState& state) { return state.surface.settings.*what; }};
}

std::vector<Command> work_commands() {
    return {
        {.name = "surface.grow",
         .menu = menu_surface,
         .label = "Grow on the surface",
         .shortcut = "Ctrl+Shift+F",
         .help = "The document's rules, or the shape grammar that is named, on the mesh and along the field.",
         .enabled = has_stage,
         .action = [](const EditorState&) -> Action { return SurfaceAction{GrowSurface{}}; }},
        {.name = "surface.step",
         .menu = menu_surface,
         .label = "One rule more",
         .help = "Of a shape grammar: applies the next rule only.",
         .enabled = has_stage,
         .action = [](const EditorState&) -> Action { return SurfaceAction{StepSurface{1}}; },
         .repeats = true},
        {.name = "surface.steps",
         .menu = menu_surface,
         .label = "Fifty rules more",
         .help = "Of a shape grammar: applies the next fifty rules.",
         .enabled = has_stage,
         .action = [](const EditorState&) -> Action {
             constexpr int many = 50;
             return SurfaceAction{StepSurface{many}};
         },
         .repeats = true},
        {.name = "surface.stop",
         .menu = menu_surface,
         .label = "Stop growing on the surface",
         .help = "What has grown until now stays.",
         .enabled = [](const EditorState& state) { return state.surface.growing; },
         .action = [](const EditorState&) -> Action { return SurfaceAction{StopSurface{}}; }},
        {.name = "surface.clear",
         .menu = menu_surface,
         .label = "Clear the surface",
         .help = "Takes what has grown from the surface; marks and field stay.",
         .enabled = [](const EditorState& state) { return state.surface.grown != nullptr; },
         .action = [](const EditorState&) -> Action { return SurfaceAction{ClearSurface{}}; }},
        {.name = "surface.fit",
         .menu = menu_surface,
         .label = "Whole surface",
         .help = "The surface in the middle, as large as fits.",
         .enabled = has_stage,
         .action = [](const EditorState&) -> Action { return SurfaceAction{FitSurface{}}; }},
    };
}

}  // namespace

std::vector<Command> surface_commands() {
    std::vector<Command> all = work_commands();
    all.push_back(tool_command<SurfaceTool::turn>("turn", "Turn", "The left mouse button turns the surface."));
    all.push_back(tool_command<SurfaceTool::element>("element", "Put field elements",
                                                     "A click puts a design element of the field; dragging moves one."));
    all.push_back(tool_command<SurfaceTool::seed>("seed", "Put seeds",
                                                  "A click puts a seed where growth begins; dragging moves one."));
    all.push_back(show_command<&SurfaceSettings::ground>("ground", "Show the surface", "Under what grows on it."));
    all.push_back(show_command<&SurfaceSettings::wireframe>("wireframe", "Show its triangles", "Draws the edges of the mesh over it."));
    all.push_back(show_command<&SurfaceSettings::streamlines>("streamlines", "Show streamlines", "Lines along the field."));
    all.push_back(show_command<&SurfaceSettings::singular>("singular", "Show singular points",
                                                           "Where the field has no direction, coloured by their index."));
    return all;
}

}  // namespace rinceau
