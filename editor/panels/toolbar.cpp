// The row of buttons for what is done most often.

#include <imgui.h>

#include <array>
#include <string_view>

#include "editor/panels/command_menu.h"

namespace rinceau {
namespace {

/// Commands by name; an empty name stands for a gap. Those that the table does not have are left out.
constexpr std::array<const char*, 20> toolbar_commands{
    "file.open",        "file.sample",     "file.save", "file.export",  "",
    "edit.undo",        "edit.redo",       "",          "view.fit",     "view.zoom_in",
    "view.zoom_out",    "view.onion",      "",          "analysis.run", "",
    "tools.symmetrize", "tools.randomize", "",          "help.palette", "help.help"};

float button_width(const Command& command) {
    return ImGui::CalcTextSize(command.label.c_str()).x + 2 * ImGui::GetStyle().FramePadding.x;
}

/// Buttons for which there is no room, in a menu.
void draw_rest(std::size_t first, const EditorState& state, const PanelTools& tools, Actions& actions) {
    if (ImGui::Button("...##more")) ImGui::OpenPopup("more");
    note_place(tools, "toolbar/more");
    if (!ImGui::BeginPopup("more")) return;
    for (std::size_t i = first; i < toolbar_commands.size(); ++i) {
        if (const Command* command = find_command(toolbar_commands[i])) command_entry(*command, state, tools, actions);
    }
    ImGui::EndPopup();
}

}  // namespace

Actions toolbar(const EditorState& state, const PanelTools& tools) {
    Actions actions;
    const ImGuiStyle& style = ImGui::GetStyle();
    const float end = ImGui::GetContentRegionMax().x;
    const float rest = ImGui::CalcTextSize("...").x + 2 * style.FramePadding.x + style.ItemSpacing.x;
    float at = ImGui::GetCursorPosX();
    for (std::size_t i = 0; i < toolbar_commands.size(); ++i) {
        const Command* command = find_command(toolbar_commands[i]);
        if (command == nullptr) {
            if (std::string_view(toolbar_commands[i]).empty()) at += style.ItemSpacing.x;
            continue;
        }
        ImGui::SetCursorPosX(at);
        if (at + button_width(*command) + rest > end) {
            draw_rest(i, state, tools, actions);
            return actions;
        }
        command_button(*command, "toolbar", state, tools, actions);
        at += button_width(*command) + style.ItemSpacing.x;
        ImGui::SameLine();
    }
    ImGui::NewLine();
    return actions;
}

}  // namespace rinceau
