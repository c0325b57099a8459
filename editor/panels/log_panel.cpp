// What happened.

#include <imgui.h>

#include "editor/panels/panel.h"
#include "editor/panels/theme.h"

namespace rinceau {

Actions log_panel(const EditorState& state, const PanelTools& tools) {
    Actions actions;
    if (state.messages.empty()) ImGui::TextDisabled("Nothing has happened yet.");
    const bool at_end = ImGui::GetScrollY() >= ImGui::GetScrollMaxY();
    for (const EditorMessage& message : state.messages) {
        ImGui::PushStyleColor(ImGuiCol_Text, message_colour(message.kind, state.shell.dark));
        ImGui::TextWrapped("%s", message.text.c_str());
        ImGui::PopStyleColor();
        note_place(tools, "log/message");
    }
    if (at_end) ImGui::SetScrollHereY(1);
    if (ImGui::BeginPopupContextWindow("log menu")) {
        if (ImGui::MenuItem("Copy all")) {
            std::string all;
            for (const EditorMessage& message : state.messages) all += message.text + '\n';
            ImGui::SetClipboardText(all.c_str());
        }
        if (ImGui::MenuItem("Clear")) actions.push_back(ShellAction{DismissMessages{}});
        ImGui::EndPopup();
    }
    return actions;
}

}  // namespace rinceau
