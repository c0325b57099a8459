// How deep the grammar is derived, and with which seed.

#include <imgui.h>

#include <algorithm>

#include "editor/panels/rules_panel_parts.h"

namespace rinceau {
namespace {

constexpr float name_width = 6;  // in heights of a letter
constexpr float button_width = 6;

void begin_line(const char* name) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(name);
    ImGui::SameLine(name_width * ImGui::GetFontSize());
}

void draw_depth(const EditorState& state, const PanelTools& tools, Actions& actions) {
    constexpr int some_depth = 20;  // where it is not known
    const int deepest = state.rules.depth < 0 ? some_depth : std::max(state.rules.depth, 1);
    const int depth = shown_document(state).derive.depth;
    int value = depth < 0 ? deepest : depth;
    begin_line("Depth");
    ImGui::SetNextItemWidth(-button_width * ImGui::GetFontSize());
    const char* const format = depth < 0 ? "all" : "%d";
    if (ImGui::SliderInt("##depth", &value, 0, std::max(deepest, value), format, ImGuiSliderFlags_NoInput))
        actions.push_back(RulesAction{SetDepth{value >= deepest ? -1 : value, true}});
    note_place(tools, "rules/Depth");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("How many steps are derived: at the right end all");
    if (ImGui::IsItemDeactivatedAfterEdit()) actions.push_back(RulesAction{CommitPreview{}});
    ImGui::SameLine();
    ImGui::BeginDisabled(depth < 0);
    if (ImGui::Button("All##depth", {-1, 0})) actions.push_back(RulesAction{SetDepth{-1}});
    note_place(tools, "rules/Depth all");
    ImGui::EndDisabled();
}

void draw_seed(const EditorState& state, const PanelTools& tools, Actions& actions) {
    const Document& document = state.document;
    const std::uint64_t seed = document.derive.seed.value_or(document.grammar->seed.value_or(1));
    std::uint64_t typed = seed;
    begin_line("Seed");
    ImGui::SetNextItemWidth(-button_width * ImGui::GetFontSize());
    ImGui::InputScalar("##seed", ImGuiDataType_U64, &typed);
    note_place(tools, "rules/Seed");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Another seed draws a relative of a grammar with random numbers");
    if (ImGui::IsItemDeactivatedAfterEdit() && typed != seed) actions.push_back(RulesAction{SetSeed{typed}});
    ImGui::SameLine();
    if (ImGui::Button("New seed", {-1, 0})) actions.push_back(RulesAction{SetSeed{seed + 1}});
    note_place(tools, "rules/New seed");
}

}  // namespace

void draw_derivation(const EditorState& state, const PanelTools& tools, Actions& actions) {
    draw_depth(state, tools, actions);
    if (state.rules.sheet->random) draw_seed(state, tools, actions);
}

}  // namespace rinceau
