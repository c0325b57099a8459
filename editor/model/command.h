#pragma once
// Commands as data: menus, shortcuts, the toolbar, the help window and tooltips are made from these.

#include <string>
#include <vector>

#include "editor/model/action.h"
#include "editor/model/editor_state.h"

namespace rinceau {

struct Command {
    std::string name;                                     ///< "file.save"
    std::string menu;                                     ///< "File"; "File/Export" = a menu within that one
    std::string label;                                    ///< "Save"
    std::string shortcut;                                 ///< "Ctrl+S", "Ctrl+Shift+S", "Delete", "+"; empty = none
    std::string help;                                     ///< a sentence for the tooltip and the help window
    bool (*enabled)(const EditorState& state) = nullptr;  ///< null = always
    Action (*action)(const EditorState& state) = nullptr;
    bool (*checked)(const EditorState& state) = nullptr;  ///< of a command that switches something: is it on?
    bool toolbar = false;                                 ///< it is a button of the toolbar, too
};

/// Can it be given now?
bool is_enabled(const Command& command, const EditorState& state);

// Of one area each, in the order of the menu.
std::vector<Command> file_commands();
std::vector<Command> rules_commands();
std::vector<Command> tools_commands();
std::vector<Command> canvas_commands();
std::vector<Command> analysis_commands();
std::vector<Command> shell_commands();

/// All of them, menu after menu: names and shortcuts are unique.
std::vector<Command> all_commands();

}  // namespace rinceau
