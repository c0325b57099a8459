#pragma once
// What every panel gets and gives: it takes the state, draws itself with Dear ImGui and returns what the user did.

#include <functional>
#include <string>
#include <vector>

#include "editor/model/action.h"
#include "editor/model/editor_state.h"
#include "editor/model/places_json.h"
#include "editor/panels/fonts.h"

namespace rinceau {

struct PanelTools {
    float scale = 1;                              ///< of fonts and widgets, in window coordinates
    EditorFonts fonts;                            ///< the usual one is set anyway
    unsigned canvas_texture = 0;                  ///< of PictureRenderer
    std::string shortcoming;                      ///< what of the picture the canvas cannot show; empty = all is shown
    std::function<unsigned(int look)> thumbnail;  ///< a square texture, lowest row first, of a look of the picture that is
                                                  ///< shown; 0 = not yet. Empty: there are none
    std::vector<WidgetPlace>* places = nullptr;   ///< null = nobody asks
};

/// Notes the place of the widget that was drawn last: the part that is not scrolled out of sight.
void note_place(const PanelTools& tools, const std::string& name);

// Each in the file of its name. They draw into the current window or child; dialogs open windows of their own.
Actions canvas_panel(const EditorState& state, const PanelTools& tools);
Actions rules_panel(const EditorState& state, const PanelTools& tools);
Actions terminals_panel(const EditorState& state, const PanelTools& tools);
Actions tools_panel(const EditorState& state, const PanelTools& tools);
Actions growth_panel(const EditorState& state, const PanelTools& tools);
Actions analysis_panel(const EditorState& state, const PanelTools& tools);
Actions log_panel(const EditorState& state, const PanelTools& tools);
Actions file_dialogs(const EditorState& state, const PanelTools& tools);

// Parts of the window around the panels.
Actions menu_bar(const EditorState& state, const PanelTools& tools);
Actions toolbar(const EditorState& state, const PanelTools& tools);
Actions welcome_panel(const EditorState& state, const PanelTools& tools);
Actions status_line(const EditorState& state, const PanelTools& tools);
Actions help_window(const EditorState& state, const PanelTools& tools);
Actions command_palette(const EditorState& state, const PanelTools& tools);

/// The whole window: menu, toolbar, panels, canvas, status line, and the windows over them.
Actions editor_window(const EditorState& state, const PanelTools& tools);

}  // namespace rinceau
