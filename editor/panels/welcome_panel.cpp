// What an empty document says in the middle of the canvas.

#include <imgui.h>

#include <array>

#include "editor/model/surface_view.h"
#include "editor/panels/command_menu.h"

namespace rinceau {
namespace {

constexpr std::array<const char*, 3> first_steps{"file.open", "file.sample", "help.help"};

void centred(const std::string& text, float middle, bool faint) {
    ImGui::SetCursorPosX(middle - ImGui::CalcTextSize(text.c_str()).x / 2);
    if (faint) {
        ImGui::TextDisabled("%s", text.c_str());
    } else {
        ImGui::TextUnformatted(text.c_str());
    }
}

float row_width() {
    const ImGuiStyle& style = ImGui::GetStyle();
    float width = -style.ItemSpacing.x;
    for (const char* name : first_steps)
        if (const Command* command = find_command(name))
            width += ImGui::CalcTextSize(command->label.c_str()).x + 2 * style.FramePadding.x + style.ItemSpacing.x;
    return width;
}

}  // namespace

Actions welcome_panel(const EditorState& state, const PanelTools& tools) {
    Actions actions;
    const Document& document = state.document;
    const bool empty = !document.drawing && document.grammar->terminals.empty() && document.grammar->productions.empty();
    if (!empty || !state.file.path.empty() || state.file.opening || shows_surface(state)) return actions;
    const ImVec2 room = ImGui::GetWindowSize();
    constexpr float lines = 5;  // what follows, about its middle
    ImGui::SetCursorPosY(room.y / 2 - lines / 2 * ImGui::GetTextLineHeightWithSpacing());
    centred("Nothing is open.", room.x / 2, false);
    centred("Open a drawing (.svg) to find its rules, or a grammar (.lsys).", room.x / 2, true);
    ImGui::Spacing();
    ImGui::SetCursorPosX(room.x / 2 - row_width() / 2);
    for (const char* name : first_steps) {
        const Command* command = find_command(name);
        if (command == nullptr) continue;
        command_button(*command, "welcome", state, tools, actions);
        ImGui::SameLine();
    }
    ImGui::NewLine();
    ImGui::Spacing();
    centred("Or drop a file here.", room.x / 2, true);
    return actions;
}

}  // namespace rinceau
