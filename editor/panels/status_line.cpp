// The last line of the window: what happened last, what is shown, what is under way.

#include <imgui.h>

#include <cstdio>

#include "editor/model/growth_view.h"
#include "editor/panels/command_menu.h"
#include "editor/panels/theme.h"

namespace rinceau {
namespace {

constexpr double percent = 100;
constexpr double milliseconds = 1000;

std::string counted(std::size_t count, const char* one, const char* many) {
    return std::to_string(count) + ' ' + (count == 1 ? one : many);
}

std::string formatted(const char* format, double value) {
    char text[32];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

/// Elements, rules, zoom and the time that deriving takes.
std::string figures(const EditorState& state) {
    const auto& picture = canvas_picture(state);
    if (!picture) return {};
    const std::string apart = "  \u00b7  ";
    const auto rules = shown_document(state).grammar->productions.size();
    std::string text = counted(picture->items.size(), "element", "elements");
    text += apart + counted(rules, "rule", "rules");
    text += apart + formatted("%.3g %%", percent * state.canvas.view.zoom);
    if (picture->seconds > 0) text += apart + formatted("%.1f ms", milliseconds * picture->seconds);
    return text;
}

EditorMessage newest(const EditorState& state, const PanelTools& tools) {
    if (!state.picture_mistake.empty()) return {MessageKind::mistake, state.picture_mistake};
    if (!tools.shortcoming.empty()) return {MessageKind::warning, tools.shortcoming};
    return state.messages.empty() ? EditorMessage{} : state.messages.back();
}

/// As much of its first line as there is room for; the whole as a tooltip. A click opens the log.
void draw_message(const EditorState& state, const PanelTools& tools, float width, Actions& actions) {
    const EditorMessage message = newest(state, tools);
    const std::string line = message.text.substr(0, message.text.find('\n'));
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float height = ImGui::GetTextLineHeight();
    if (ImGui::InvisibleButton("message", {std::max(1.0F, width), height}))
        actions.push_back(ShellAction{ShowPanel{EditorPanel::log, !state.shell.shown.log}});
    note_place(tools, "status/message");
    if (!message.text.empty()) tooltip(message.text);
    const ImVec4 colour = message_colour(message.kind, state.shell.dark);
    const ImVec4 clip{corner.x, corner.y, corner.x + width, corner.y + height};
    ImGui::GetWindowDrawList()->AddText(nullptr, 0, corner, ImGui::GetColorU32(colour), line.c_str(), nullptr, 0, &clip);
}

void draw_progress(const EditorState& state, const PanelTools& tools, float width) {
    ImGui::SameLine();
    ImGui::ProgressBar(static_cast<float>(state.analysis.fraction), {width, ImGui::GetTextLineHeight()},
                       state.analysis.stage.c_str());
    note_place(tools, "status/progress");
}

}  // namespace

Actions status_line(const EditorState& state, const PanelTools& tools) {
    Actions actions;
    constexpr float progress_width = 11;  // letters' heights
    const std::string text = figures(state);
    const float gap = 2 * ImGui::GetStyle().ItemSpacing.x;
    const float progress = state.analysis.running ? progress_width * ImGui::GetFontSize() : 0;
    const float taken = ImGui::CalcTextSize(text.c_str()).x + gap + (state.analysis.running ? progress + gap : 0);
    draw_message(state, tools, ImGui::GetContentRegionAvail().x - taken, actions);
    if (state.analysis.running) draw_progress(state, tools, progress);
    ImGui::SameLine();
    ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(text.c_str()).x);
    ImGui::TextUnformatted(text.c_str());
    note_place(tools, "status/figures");
    return actions;
}

}  // namespace rinceau
