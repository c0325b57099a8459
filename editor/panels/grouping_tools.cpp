// Similarity groups by hand: the analysis follows.

#include <imgui.h>

#include <algorithm>

#include "editor/panels/analysis_parts.h"

namespace rinceau {
namespace {

/// Terminals side by side, as many in a line as there is room for.
void terminal_boxes(const EditorState& state, const PanelTools& tools, Actions& actions) {
    const std::vector<std::string>& merging = state.clusters.merging;
    const float room = ImGui::GetContentRegionAvail().x;
    float used = 0;
    for (const Terminal& terminal : shown_document(state).resolved->terminals) {
        if (!terminal.verbatim.empty()) continue;
        const float width = ImGui::GetFrameHeightWithSpacing() + ImGui::CalcTextSize(terminal.symbol.c_str()).x +
                            ImGui::GetStyle().ItemSpacing.x;
        if (used > 0 && used + width <= room) ImGui::SameLine();
        used = used + width <= room ? used + width : width;
        bool chosen = std::ranges::find(merging, terminal.symbol) != merging.end();
        if (ImGui::Checkbox((terminal.symbol + "##merge").c_str(), &chosen))
            actions.push_back(AnalysisAction{ChooseTerminal{terminal.symbol, chosen}});
        note_place(tools, "analysis/merge " + terminal.symbol);
    }
}

void button(const char* label, bool enabled, const char* help, const PanelTools& tools, Action action, Actions& actions) {
    ImGui::BeginDisabled(!enabled);
    if (ImGui::Button(label)) actions.push_back(std::move(action));
    ImGui::EndDisabled();
    note_place(tools, std::string("analysis/") + label);
    if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) ImGui::SetTooltip("%s", help);
}

}  // namespace

Actions grouping_tools(const EditorState& state, const PanelTools& tools) {
    Actions actions;
    const ClustersState& clusters = state.clusters;
    ImGui::TextWrapped("Terminals that shall be one (the first that is chosen is drawn for all):");
    constexpr float lines = 4;
    const float height = lines * ImGui::GetFrameHeightWithSpacing();
    if (ImGui::BeginChild("merge", {0, height}, true)) terminal_boxes(state, tools, actions);
    ImGui::EndChild();
    const bool can_merge = clusters.merging.size() > 1;
    const std::string first = can_merge ? "Draws " + clusters.merging.front() + " for all of them and analyses anew."
                                        : "Choose two terminals or more.";
    button("Merge", can_merge, first.c_str(), tools, AnalysisAction{MergeTerminals{}}, actions);
    ImGui::SameLine();
    button("Split off", state.canvas.selection.has_value(),
           "The elements that are selected on the canvas become a terminal of their own.", tools,
           AnalysisAction{SplitSelection{}}, actions);
    ImGui::SameLine();
    button("Forget groups", !shown_document(state).analysis.grouping.empty(),
           "Leaves it to the analysis again which elements are copies of which.", tools, AnalysisAction{ForgetGrouping{}},
           actions);
    return actions;
}

}  // namespace rinceau
