// What was left behind by windows that ended without being closed.

#include "editor/panels/recovery_window.h"

#include <imgui.h>

#include <array>
#include <ctime>

#include "editor/panels/modal_window.h"

namespace rinceau {
namespace {

constexpr float text_width = 560;  // at scale 1

std::string time_text(std::int64_t seconds) {
    const std::time_t time = seconds;
    std::tm parts{};
    if (::localtime_r(&time, &parts) == nullptr) return {};
    std::array<char, 32> text{};
    const std::size_t length = std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M:%S", &parts);
    return {text.data(), length};
}

void entry_row(const Recoverable& entry, const PanelTools& tools, const std::string& which, Actions& actions) {
    ImGui::PushID(entry.file.c_str());
    if (entry.mistake.empty()) {
        if (ImGui::Button("Open")) actions.push_back(RecoveryAction{OpenRecoverable{entry.file}});
        note_place(tools, "recover/Open" + which);
        ImGui::SameLine();
    }
    if (ImGui::Button("Discard")) actions.push_back(RecoveryAction{DiscardRecoverable{entry.file}});
    note_place(tools, "recover/Discard" + which);
    ImGui::SameLine();
    const std::string name = entry.path.empty() ? "a document without a file" : entry.path;
    ImGui::Text("%s  %s", time_text(entry.modified).c_str(), name.c_str());
    if (!entry.mistake.empty()) ImGui::TextWrapped("%s", entry.mistake.c_str());
    ImGui::PopID();
}

}  // namespace

Actions recovery_window(const EditorState& state, const PanelTools& tools) {
    const auto& found = state.recovery.found;
    const bool wanted = !found.empty() && !state.file.question && !state.file.opening;
    ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Always, {0.5F, 0.5F});
    if (!begin_modal("Work that was not saved###recovery", wanted, ImGuiWindowFlags_AlwaysAutoResize)) return {};
    Actions actions;
    ImGui::PushTextWrapPos(text_width * tools.scale);
    ImGui::TextUnformatted(
        "Rinceau ended before this was saved. Open shows it here, still unsaved; Discard removes it for good; Later asks "
        "again "
        "at the next start.");
    ImGui::Spacing();
    for (std::size_t i = 0; i < found.size(); ++i)
        entry_row(found[i], tools, i == 0 ? std::string() : '.' + std::to_string(i + 1), actions);
    ImGui::PopTextWrapPos();
    ImGui::Spacing();
    if (ImGui::Button("Later") || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false))
        actions.push_back(RecoveryAction{PostponeRecovery{}});
    note_place(tools, "recover/Later");
    const bool enter = !ImGui::IsWindowAppearing() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter), false);
    if (enter && actions.empty() && found.front().mistake.empty())
        actions.push_back(RecoveryAction{OpenRecoverable{found.front().file}});
    ImGui::EndPopup();
    return actions;
}

}  // namespace rinceau
