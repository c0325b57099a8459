#include "editor/panels/command_menu.h"

#include <imgui.h>

#include <algorithm>

namespace rinceau {
namespace {

void tooltip(const Command& command) {
    if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
    constexpr float widest = 32;  // in letters' heights
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(widest * ImGui::GetFontSize());
    ImGui::TextUnformatted(command.help.c_str());
    ImGui::PopTextWrapPos();
    if (!command.shortcut.empty()) ImGui::TextDisabled("%s", command.shortcut.c_str());
    ImGui::EndTooltip();
}

}  // namespace

const std::vector<Command>& commands() {
    static const std::vector<Command> all = all_commands();
    return all;
}

const Command* find_command(const std::string& name) {
    const auto found = std::ranges::find(commands(), name, &Command::name);
    return found == commands().end() ? nullptr : &*found;
}

void command_entry(const Command& command, const EditorState& state, const PanelTools& tools, Actions& actions) {
    const bool checked = command.checked != nullptr && command.checked(state);
    if (ImGui::MenuItem(command.label.c_str(), command.shortcut.c_str(), checked, is_enabled(command, state)))
        actions.push_back(command.action(state));
    note_place(tools, "menu/" + command.name);
    tooltip(command);
}

void command_button(const Command& command, const std::string& area, const EditorState& state, const PanelTools& tools,
                    Actions& actions) {
    ImGui::BeginDisabled(!is_enabled(command, state));
    if (ImGui::Button((command.label + "##" + command.name).c_str())) actions.push_back(command.action(state));
    note_place(tools, area + "/" + command.name);
    ImGui::EndDisabled();
    tooltip(command);
}

}  // namespace rinceau
