#pragma once
// A command as a menu entry or a button: what it says, its key and its tooltip come from the command.

#include "editor/model/command.h"
#include "editor/panels/panel.h"

namespace rinceau {

/// All commands; made once.
const std::vector<Command>& commands();

/// The command of that name; null if there is none.
const Command* find_command(const std::string& name);

/// An entry of the open menu, its place noted as "menu/NAME".
void command_entry(const Command& command, const EditorState& state, const PanelTools& tools, Actions& actions);

/// A button in the current window, its place noted as "AREA/NAME".
void command_button(const Command& command, const std::string& area, const EditorState& state, const PanelTools& tools,
                    Actions& actions);

}  // namespace rinceau
