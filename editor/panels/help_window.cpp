// All commands with their keys, menu after menu.

#include <imgui.h>

#include <algorithm>

#include "editor/panels/command_menu.h"

namespace rinceau {
namespace {

void draw_menu_table(const std::string& menu, const PanelTools& tools) {
    ImGui::Spacing();
    ImGui::TextDisabled("%s", menu.c_str());
    note_place(tools, "help/" + menu);
    if (!ImGui::BeginTable(menu.c_str(), 3, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchProp)) return;
    constexpr float label_share = 3, key_share = 2.4F, help_share = 6;
    ImGui::TableSetupColumn("", 0, label_share);
    ImGui::TableSetupColumn("", 0, key_share);
    ImGui::TableSetupColumn("", 0, help_share);
    for (const Command& command : commands()) {
        if (command.menu != menu) continue;
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextWrapped("%s", command.label.c_str());
        ImGui::TableNextColumn();
        ImGui::TextWrapped("%s", shortcut_text(command.shortcut).c_str());
        ImGui::TableNextColumn();
        ImGui::TextWrapped("%s", command.help.c_str());
    }
    ImGui::EndTable();
}

void draw_habits() {
    ImGui::Spacing();
    ImGui::TextDisabled("Mouse and keyboard");
    ImGui::TextWrapped(
        "Canvas: the wheel zooms to the cursor; the middle or right button, or Space with the left, moves. "
        "Click an element to select it, click again for the rule above.\n"
        "Numbers: drag sideways; double-click or Ctrl+click to type; Tab goes to the next field.\n"
        "Menus: Alt or F10, then arrows and Enter. Panels: F6; in a panel the arrows move, Space presses, Enter types. "
        "Esc drops what is being dragged or typed.");
}

}  // namespace

Actions help_window(const EditorState& state, const PanelTools& tools) {
    if (!state.shell.help) return {};
    constexpr float share = 0.8F;  // of the window
    constexpr float widest = 56;   // letters' heights
    const ImVec2 room = ImGui::GetMainViewport()->WorkSize;
    const float width = std::min(share * room.x, widest * ImGui::GetFontSize());
    ImGui::SetNextWindowSize({width, share * room.y}, ImGuiCond_Appearing);
    ImGui::SetNextWindowPos({room.x / 2, room.y / 2}, ImGuiCond_Appearing, {0.5F, 0.5F});
    bool open = true;
    if (ImGui::Begin("Commands and keys", &open, ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings)) {
        draw_habits();
        std::vector<std::string> menus;
        for (const Command& command : commands())
            if (std::ranges::find(menus, command.menu) == menus.end()) menus.push_back(command.menu);
        for (const std::string& menu : menus) draw_menu_table(menu, tools);
    }
    const bool escaped = ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows) &&
                         ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false);
    ImGui::End();
    if (open && !escaped) return {};
    return {ShellAction{ShowHelp{false}}};
}

}  // namespace rinceau
