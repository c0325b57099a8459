// The window as a whole.

#include <imgui.h>

#include "editor/panels/panel.h"

namespace rinceau {
namespace {

constexpr float side_width = 300;  ///< at scale 1
constexpr float log_height = 120;

void add(Actions& all, Actions more) {
    for (Action& action : more) all.push_back(std::move(action));
}

void child(const char* name, ImVec2 size, Actions& actions, const EditorState& state, const PanelTools& tools,
           Actions (*panel)(const EditorState&, const PanelTools&)) {
    if (ImGui::BeginChild(name, size, true)) add(actions, panel(state, tools));
    ImGui::EndChild();
}

}  // namespace

Actions editor_window(const EditorState& state, const PanelTools& tools) {
    Actions actions;
    const ImGuiViewport* viewport = ImGui::GetMainViewport();
    ImGui::SetNextWindowPos(viewport->WorkPos);
    ImGui::SetNextWindowSize(viewport->WorkSize);
    constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_MenuBar | ImGuiWindowFlags_NoMove |
                                       ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;
    ImGui::Begin("Rinceau", nullptr, flags);
    add(actions, menu_bar(state, tools));
    const float side = side_width * tools.scale;
    const float height = -log_height * tools.scale;
    ImGui::BeginGroup();
    child("terminals", {side, 2 * height}, actions, state, tools, terminals_panel);
    child("analysis", {side, height}, actions, state, tools, analysis_panel);
    ImGui::EndGroup();
    ImGui::SameLine();
    child("canvas", {-side, height}, actions, state, tools, canvas_panel);
    ImGui::SameLine();
    ImGui::BeginGroup();
    child("rules", {0, 2 * height}, actions, state, tools, rules_panel);
    child("tools", {0, height}, actions, state, tools, tools_panel);
    ImGui::EndGroup();
    child("log", {0, 0}, actions, state, tools, log_panel);
    ImGui::End();
    add(actions, file_dialogs(state, tools));
    return actions;
}

}  // namespace rinceau
