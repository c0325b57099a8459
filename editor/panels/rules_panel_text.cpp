// The whole grammar as text, with its mistakes at their places.

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "editor/panels/rules_panel_parts.h"

namespace rinceau {
namespace {

constexpr float findings_lines = 6;  // that the list of mistakes has, at most

/// Puts the cursor where it shall go.
int place_cursor(ImGuiInputTextCallbackData* data) {
    const auto* offset = static_cast<const std::size_t*>(data->UserData);
    data->CursorPos = data->SelectionStart = data->SelectionEnd = std::min(static_cast<int>(*offset), data->BufTextLen);
    return 0;
}

/// In the field's own window, which scrolls.
void mark_line(const char* id, int line) {
    ImGui::BeginChild(ImGui::GetID(id));
    const ImVec2 corner = ImGui::GetWindowPos();
    const float height = ImGui::GetFontSize();
    const float top =
        corner.y + ImGui::GetStyle().FramePadding.y + static_cast<float>(line - 1) * height - ImGui::GetScrollY();
    ImVec4 color = ImGui::GetStyleColorVec4(ImGuiCol_PlotHistogram);
    constexpr float faint = 0.25F;
    color.w = faint;
    ImGui::GetWindowDrawList()->AddRectFilled({corner.x, top}, {corner.x + ImGui::GetWindowWidth(), top + height},
                                              ImGui::GetColorU32(color));
    ImGui::EndChild();
}

void draw_editor(const RuleText& text, const PanelTools& tools, float height, Actions& actions) {
    constexpr const char* id = "##text";
    std::string written = text.text;
    ImGuiInputTextFlags flags = ImGuiInputTextFlags_AllowTabInput | ImGuiInputTextFlags_EnterReturnsTrue;
    std::size_t offset = 0;
    if (text.goes_there) {
        offset = offset_of_place(text.text, text.line, text.column);
        flags |= ImGuiInputTextFlags_CallbackAlways;
        ImGui::SetKeyboardFocusHere();
    }
    const bool entered =
        ImGui::InputTextMultiline(id, &written, {-1, height}, flags, text.goes_there ? place_cursor : nullptr, &offset);
    note_place(tools, "rules/Text");
    if (text.goes_there && ImGui::IsItemActive()) actions.push_back(RulesAction{TextPlaceShown{}});
    const bool escaped = ImGui::IsItemDeactivated() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
    if (!escaped && written != text.text) actions.push_back(RulesAction{WriteText{written}});  // Esc takes nothing back
    if (entered) actions.push_back(RulesAction{ApplyText{}});
    if (text.line > 0) mark_line(id, text.line);
}

std::string place_text(const Warning& warning, const std::string& file) {
    const std::string place = std::to_string(warning.place.line) + ':' + std::to_string(warning.place.column);
    return warning.place.file.empty() || warning.place.file == file ? place : warning.place.file + ':' + place;
}

void draw_findings(const RuleText& text, const std::vector<Warning>& findings, const char* kind, const PanelTools& tools,
                   Actions& actions) {
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(findings.size()));
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const Warning& warning = findings[static_cast<std::size_t>(i)];
            ImGui::PushID(i);
            const std::string line = place_text(warning, text.file) + "  " + warning.message;
            if (ImGui::Selectable(line.c_str(), warning.place.line == text.line && text.line > 0))
                actions.push_back(RulesAction{ShowTextPlace{warning.place.line, warning.place.column}});
            note_place(tools, std::string("rules/") + kind + ' ' + std::to_string(i + 1));
            if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", line.c_str());
            ImGui::PopID();
        }
    }
}

std::string status_of(const RuleText& text) {
    if (text.checked != text.revision) return "Looking it through ..";
    if (!text.changed && text.findings.picture.empty()) return "The text of the rules";
    if (text.findings.mistakes.empty()) return text.findings.picture;
    const std::size_t count = text.findings.mistakes.size();
    return count == 1 ? "1 mistake:" : std::to_string(count) + " mistakes:";
}

void draw_buttons(const EditorState& state, const PanelTools& tools, Actions& actions) {
    const RuleText& text = state.rules.text;
    ImGui::BeginDisabled(!text.changed);
    if (ImGui::Button("Apply")) actions.push_back(RulesAction{ApplyText{}});
    note_place(tools, "rules/Apply");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Ctrl+Enter: the text becomes the rules; it can be undone");
    ImGui::SameLine();
    if (ImGui::Button("Revert")) actions.push_back(RulesAction{RevertText{}});
    note_place(tools, "rules/Revert");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Back to the text of the rules as they are");
    ImGui::EndDisabled();
    ImGui::SameLine();
    const bool outdated = text.changed && text.grammar != state.document.grammar;
    ImGui::TextDisabled("%s", outdated ? "not applied; the rules have changed since" : text.changed ? "not applied" : "");
}

}  // namespace

void draw_rule_text(const EditorState& state, const PanelTools& tools, Actions& actions) {
    const RuleText& text = state.rules.text;
    draw_buttons(state, tools, actions);
    const std::size_t lines = text.findings.mistakes.size() + text.findings.hints.size();
    const float below = (1 + std::min(findings_lines, static_cast<float>(lines))) * ImGui::GetTextLineHeightWithSpacing() +
                        2 * ImGui::GetStyle().ItemSpacing.y;
    constexpr float fewest_lines = 5;
    const float height = std::max(ImGui::GetContentRegionAvail().y - below, fewest_lines * ImGui::GetTextLineHeight());
    draw_editor(text, tools, height, actions);
    ImGui::TextWrapped("%s", status_of(text).c_str());
    note_place(tools, "rules/Status");
    if (lines == 0) return;
    ImGui::BeginChild("findings");
    draw_findings(text, text.findings.mistakes, "mistake", tools, actions);
    draw_findings(text, text.findings.hints, "hint", tools, actions);
    ImGui::EndChild();
}

}  // namespace rinceau
