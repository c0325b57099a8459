// Every command by a part of its name.

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "editor/panels/command_menu.h"
#include "editor/panels/frame_timing.h"

namespace rinceau {
namespace {

constexpr const char* popup = "Find a command";

bool pressed(ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)); }

/// A row for a command; true if it was clicked.
bool draw_row(const Command& command, bool chosen, const EditorState& state, const PanelTools& tools) {
    ImGui::BeginDisabled(!is_enabled(command, state));
    const std::string menu = command.menu + " > ";
    const bool clicked = ImGui::Selectable((menu + command.label + "##" + command.name).c_str(), chosen);
    note_place(tools, "palette/" + command.name);
    tooltip(command.help);
    const std::string keys = first_shortcut(command);
    ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(keys.c_str()).x);
    ImGui::TextDisabled("%s", keys.c_str());
    ImGui::EndDisabled();
    return clicked;
}

const Command* draw_list(const std::vector<const Command*>& found, int chosen, bool moved, const EditorState& state,
                         const PanelTools& tools) {
    const Command* clicked = nullptr;
    constexpr float rows = 14;
    ImGui::BeginChild("found", {0, rows * ImGui::GetTextLineHeightWithSpacing()});
    for (std::size_t i = 0; i < found.size(); ++i) {
        const bool is_chosen = static_cast<int>(i) == chosen;
        if (draw_row(*found[i], is_chosen, state, tools)) clicked = found[i];
        if (is_chosen && moved) ImGui::SetScrollHereY();
    }
    if (found.empty()) ImGui::TextDisabled("No command has these words");
    ImGui::EndChild();
    return clicked;
}

/// What is typed and which row is chosen; tells the state if they changed.
int edit_search(const EditorState& state, const PanelTools& tools, Actions& actions, std::string& text, int& rows) {
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-1);
    bool changed = ImGui::InputTextWithHint("##words", "Part of a command's name", &text);
    note_place(tools, "palette/words");
    rows = static_cast<int>(matching_commands(commands(), text).size());
    int chosen = changed ? 0 : state.shell.palette_chosen;
    if (pressed(ImGuiKey_DownArrow)) ++chosen;
    if (pressed(ImGuiKey_UpArrow)) --chosen;
    chosen = std::clamp(chosen, 0, std::max(0, rows - 1));
    if (changed || chosen != state.shell.palette_chosen) actions.push_back(ShellAction{EditPalette{text, chosen}});
    return chosen;
}

void draw_palette(const EditorState& state, const PanelTools& tools, Actions& actions) {
    std::string text = state.shell.palette_text;
    int rows = 0;
    const int chosen = edit_search(state, tools, actions, text, rows);
    const auto found = matching_commands(commands(), text);
    const Command* command = draw_list(found, chosen, chosen != state.shell.palette_chosen, state, tools);
    const bool entered = pressed(ImGuiKey_Enter) || pressed(ImGuiKey_KeyPadEnter);
    if (command == nullptr && entered && chosen < rows) command = found[static_cast<std::size_t>(chosen)];
    if (command != nullptr && is_enabled(*command, state)) {
        actions.push_back(ShellAction{ShowPalette{false}});
        actions.push_back(command->action(state));
        ImGui::CloseCurrentPopup();
    } else if (pressed(ImGuiKey_Escape)) {
        actions.push_back(ShellAction{ShowPalette{false}});
        ImGui::CloseCurrentPopup();
    }
}

}  // namespace

Actions command_palette(const EditorState& state, const PanelTools& tools) {
    Actions actions;
    if (state.shell.palette && !ImGui::IsPopupOpen(popup)) ImGui::OpenPopup(popup);
    constexpr float width = 34;  // letters' heights
    constexpr float from_top = 0.12F;
    const ImVec2 room = ImGui::GetMainViewport()->WorkSize;
    ImGui::SetNextWindowSize({std::min(width * ImGui::GetFontSize(), room.x), 0});
    ImGui::SetNextWindowPos({room.x / 2, from_top * room.y}, ImGuiCond_Always, {0.5F, 0});
    constexpr ImGuiWindowFlags flags =
        ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings;
    if (ImGui::BeginPopup(popup, flags)) {
        draw_palette(state, tools, actions);
        if (!state.shell.palette) ImGui::CloseCurrentPopup();
        ImGui::EndPopup();
    } else if (state.shell.palette) {
        actions.push_back(ShellAction{ShowPalette{false}});  // a click elsewhere has closed it
    }
    return actions;
}

}  // namespace rinceau
