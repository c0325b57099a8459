#include "editor/panels/command_menu.h"

#include <imgui.h>

#include "editor/panels/frame_timing.h"

namespace rinceau {
void command_entry(const Command& command, const EditorState& state, const PanelTools& tools, Actions& actions) {
    const bool checked = command.checked != nullptr && command.checked(state);
    if (ImGui::MenuItem(command.label.c_str(), first_shortcut(command).c_str(), checked, is_enabled(command, state)))
        actions.push_back(command.action(state));
    note_place(tools, "menu/" + command.name);
    tooltip(command.help, command.shortcut);
}

void command_button(const Command& command, const std::string& area, const EditorState& state, const PanelTools& tools,
                    Actions& actions) {
    ImGui::BeginDisabled(!is_enabled(command, state));
    if (ImGui::Button((command.label + "##" + command.name).c_str())) actions.push_back(command.action(state));
    note_place(tools, area + "/" + command.name);
    ImGui::EndDisabled();
    tooltip(command.help, command.shortcut);
}

void tooltip(const std::string& text, const std::string& shortcut) {
    if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled) || !mouse_has_rested()) return;
    constexpr float widest = 32;  // in letters' heights
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(widest * ImGui::GetFontSize());
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    if (!shortcut.empty()) ImGui::TextDisabled("%s", shortcut_text(shortcut).c_str());
    ImGui::EndTooltip();
}

}  // namespace rinceau
