#pragma once
// A command as a menu entry or a button: what it says, its key and its tooltip come from the command.

#include "editor/model/command.h"
#include "editor/panels/panel.h"

namespace rinceau {

/// An entry of the open menu, its place noted as "menu/NAME".
void command_entry(const Command& command, const EditorState& state, const PanelTools& tools, Actions& actions);

/// A button in the current window, its place noted as "AREA/NAME".
void command_button(const Command& command, const std::string& area, const EditorState& state, const PanelTools& tools,
                    Actions& actions);

/// The text as a tooltip of the item that was drawn last, when the mouse has rested on it for a moment.
void tooltip(const std::string& text, const std::string& shortcut = {});

}  // namespace rinceau
