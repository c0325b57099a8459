// The productions that the analysis found, as its report tells them.

#include <imgui.h>

#include <algorithm>

#include "editor/panels/analysis_parts.h"

namespace rinceau {
namespace {

/// The production of the grammar that is shown; none if it was edited away.
int production_of(const Grammar& grammar, const std::string& symbol) {
    const auto found = std::ranges::find(grammar.productions, symbol, &Production::symbol);
    return found == grammar.productions.end() ? no_production : static_cast<int>(found - grammar.productions.begin());
}

std::string lengths_of(const ProductionReport& rule) {
    std::string text;
    for (const int length : rule.lengths) text += (text.empty() ? "" : ", ") + std::to_string(length);
    return text;
}

void cell(const std::string& text) {
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(text.c_str());
}

}  // namespace

Actions found_rules(const EditorState& state, const PanelTools& tools) {
    Actions actions;
    const Document& document = shown_document(state);
    constexpr int columns = 4;
    constexpr ImGuiTableFlags flags = ImGuiTableFlags_RowBg | ImGuiTableFlags_Resizable | ImGuiTableFlags_BordersOuter;
    if (!ImGui::BeginTable("found", columns, flags)) return actions;
    for (const char* heading : {"rule", "kind", "lengths", "uses"}) ImGui::TableSetupColumn(heading);
    ImGui::TableHeadersRow();
    int hovered = no_production;
    bool any = false;
    for (const ProductionReport& rule : document.report->productions) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::Selectable(rule.symbol.c_str(), false, ImGuiSelectableFlags_SpanAllColumns);
        note_place(tools, "analysis/rule " + rule.symbol);
        if (ImGui::IsItemHovered() || (ImGui::IsItemFocused() && ImGui::GetIO().NavVisible)) {
            hovered = production_of(*document.grammar, rule.symbol);
            any = true;
        }
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", rule.body.c_str());
        cell(rule.kind);
        cell(lengths_of(rule));
        cell(std::to_string(rule.instances));
    }
    ImGui::EndTable();
    // What other panels hover is left alone.
    bool& was_here = *ImGui::GetStateStorage()->GetBoolRef(ImGui::GetID("rule hovered here"));
    if ((any || was_here) && hovered != state.canvas.hovered_production) actions.push_back(CanvasAction{HoverRule{hovered}});
    was_here = any;
    return actions;
}

}  // namespace rinceau
