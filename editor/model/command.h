#pragma once
// Commands as data: menus, shortcuts, the toolbar, the help window and tooltips are made from these.

#include <string>
#include <vector>

#include "editor/model/action.h"
#include "editor/model/editor_state.h"
#include "editor/model/key_chord.h"

namespace rinceau {

struct Command {
    std::string name;      ///< "file.save"
    std::string menu;      ///< "File"; "File/Export" = a menu within that one
    std::string label;     ///< "Save"
    std::string shortcut;  ///< "Ctrl+S", "Delete", "+", "Ctrl+Y Ctrl+Shift+Z" = either; empty = none
    std::string help;      ///< a sentence for the tooltip and the help window
    bool (*enabled)(const EditorState& state) = nullptr;  ///< null = always
    Action (*action)(const EditorState& state) = nullptr;
    bool (*checked)(const EditorState& state) = nullptr;        ///< of a command that switches something: is it on?
    std::string (*detail)(const EditorState& state) = nullptr;  ///< what it would do now, for the tooltip; null = as ever
    bool repeats = false;                                       ///< holding its key down gives it again and again
};

/// Can it be given now?
bool is_enabled(const Command& command, const EditorState& state);

/// The first of its keys, for a menu.
std::string first_shortcut(const Command& command);

/// "Ctrl+Y or Ctrl+Shift+Z": all of a command's keys, to read.
std::string shortcut_text(std::string shortcut);

/// The command that a key gives; null if none.
const Command* command_of_key(const std::vector<Command>& commands, const std::vector<KeyChord>& meanings);

/// Those whose menu, label or help hold every word of the text, in any case of letters: labels first.
std::vector<const Command*> matching_commands(const std::vector<Command>& commands, const std::string& text);

// Of one area each, in the order of the menu.
std::vector<Command> file_commands();
std::vector<Command> rules_commands();
std::vector<Command> tools_commands();
std::vector<Command> canvas_commands();
std::vector<Command> analysis_commands();
std::vector<Command> growth_commands();
std::vector<Command> surface_commands();
std::vector<Command> shell_commands();

/// All of them, menu after menu: names and shortcuts are unique.
std::vector<Command> all_commands();

/// The same, made once.
const std::vector<Command>& commands();

/// The command of that name; null if there is none.
const Command* find_command(const std::string& name);

}  // namespace rinceau
