// Clusters of the drawing's transformation spaces as a table.

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "editor/panels/analysis_parts.h"
#include "geometry/angle.h"

namespace rinceau {
namespace {

enum Column : int { color_column, importance_column, pairs_column, from_column, to_column, step_column, columns };

const TransformationCluster& step_of(const ClusterTable& table, const ClusterRow& row) {
    const ClusteredSpace& space = table.spaces[static_cast<std::size_t>(row.space)];
    return space.clusters.clusters[static_cast<std::size_t>(row.cluster)];
}

const TransformationSpace& space_of(const ClusterTable& table, const ClusterRow& row) {
    return table.spaces[static_cast<std::size_t>(row.space)].space;
}

const std::string& name_of(const ClusterTable& table, int look) { return table.names[static_cast<std::size_t>(look)]; }

/// "30 deg, 2.4 on, x0.9, turned 15 deg, mirrored": what does nothing is left out.
std::string step_in_words(const TransformationCluster& step) {
    constexpr double unseen = 5e-4;
    std::array<char, 128> text{};
    std::string words;
    const auto add = [&](const char* format, double value) {
        std::snprintf(text.data(), text.size(), format, value);
        words += (words.empty() ? "" : ", ") + std::string(text.data());
    };
    if (step.d > unseen) add("%.4g sizes", step.d);
    if (step.d > unseen) add("at %.4g\xc2\xb0", degrees(step.alpha));
    if (std::abs(std::log(step.s)) > unseen) add("\xc3\x97%.3g", step.s);
    if (std::abs(step.beta) > unseen) add("turned %.4g\xc2\xb0", degrees(step.beta));
    if (step.mirrored) words += words.empty() ? "mirrored" : ", mirrored";
    return words.empty() ? "in the same place" : words;
}

/// Rows in the order that the table's heading asks for.
std::vector<std::size_t> sorted_rows(const ClusterTable& table, const RankedClusters& ranked) {
    std::vector<std::size_t> order = ranked.order;
    const ImGuiTableSortSpecs* specs = ImGui::TableGetSortSpecs();
    if (specs == nullptr || specs->SpecsCount == 0) return order;
    const int column = specs->Specs[0].ColumnIndex;
    const bool falling = specs->Specs[0].SortDirection == ImGuiSortDirection_Descending;
    const auto before = [&](std::size_t a, std::size_t b) {
        const ClusterRow& x = table.rows[falling ? b : a];
        const ClusterRow& y = table.rows[falling ? a : b];
        switch (column) {
            case from_column:
                return name_of(table, space_of(table, x).from) < name_of(table, space_of(table, y).from);
            case to_column:
                return name_of(table, space_of(table, x).to) < name_of(table, space_of(table, y).to);
            case step_column:
                return step_of(table, x).d < step_of(table, y).d;
            case pairs_column:
                return step_of(table, x).count < step_of(table, y).count;
            default:
                return ranked.importance[falling ? b : a] < ranked.importance[falling ? a : b];
        }
    };
    std::ranges::stable_sort(order, before);
    return order;
}

void set_up_columns() {
    ImGui::TableSetupScrollFreeze(0, 1);  // the heading stays
    constexpr ImGuiTableColumnFlags falling = ImGuiTableColumnFlags_PreferSortDescending;
    ImGui::TableSetupColumn("##colour", ImGuiTableColumnFlags_NoSort);
    ImGui::TableSetupColumn("importance", falling | ImGuiTableColumnFlags_DefaultSort);
    ImGui::TableSetupColumn("pairs", falling);
    ImGui::TableSetupColumn("from");
    ImGui::TableSetupColumn("to");
    ImGui::TableSetupColumn("step");
    ImGui::TableHeadersRow();
}

void color_cell(int cluster) {
    const float side = ImGui::GetTextLineHeight();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    constexpr float inset = 0.2F;  // of the side
    ImGui::GetWindowDrawList()->AddRectFilled({corner.x + inset * side, corner.y + inset * side},
                                              {corner.x + (1 - inset) * side, corner.y + (1 - inset) * side},
                                              cluster_color(cluster));
    ImGui::Dummy({side, side});
}

void importance_tip(const ClusterRow& row, double importance) {
    ImGui::SetTooltip("importance %.3f: %.0f elements (n), nearness %.3f (h), similarity %.3f (phi), length %.1f (l)",
                      importance, row.terms.elements, row.terms.nearness, row.terms.similarity, row.terms.length);
}

/// One row, the so manieth of those that are shown; true if the mouse is over it.
bool show_row(const EditorState& state, const PanelTools& tools, int place, std::size_t index, double importance,
              Actions& actions) {
    const ClusterTable& table = state.clusters.found->table;
    const ClusterRow& row = table.rows[index];
    const int number = static_cast<int>(index);
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    color_cell(row.cluster);
    ImGui::TableNextColumn();
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), "%.3f", importance);
    ImGui::PushID(number);
    if (ImGui::Selectable(text.data(), state.clusters.kept == number, ImGuiSelectableFlags_SpanAllColumns))
        actions.push_back(AnalysisAction{KeepCluster{number}});
    ImGui::PopID();
    note_place(tools, "analysis/cluster " + std::to_string(place + 1));
    const bool hovered = ImGui::IsItemHovered() || (ImGui::IsItemFocused() && ImGui::GetIO().NavVisible);
    if (ImGui::IsItemHovered()) importance_tip(row, importance);
    ImGui::TableNextColumn();
    ImGui::Text("%d", step_of(table, row).count);
    for (const std::string& words : {name_of(table, space_of(table, row).from), name_of(table, space_of(table, row).to),
                                     step_in_words(step_of(table, row))}) {
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(words.c_str());
    }
    return hovered;
}

}  // namespace

unsigned cluster_color(int cluster) {
    constexpr std::array<ImU32, 10> colors = {
        IM_COL32(27, 108, 168, 255), IM_COL32(209, 73, 91, 255), IM_COL32(42, 157, 85, 255), IM_COL32(224, 159, 62, 255),
        IM_COL32(123, 79, 163, 255), IM_COL32(0, 166, 166, 255), IM_COL32(160, 82, 45, 255), IM_COL32(227, 119, 194, 255),
        IM_COL32(107, 142, 35, 255), IM_COL32(51, 65, 85, 255)};
    constexpr ImU32 grey = IM_COL32(184, 188, 194, 255);
    return cluster < static_cast<int>(colors.size()) ? colors[static_cast<std::size_t>(cluster)] : grey;
}

Actions clusters_table(const EditorState& state, const PanelTools& tools) {
    Actions actions;
    const ClusterTable& table = state.clusters.found->table;
    if (table.rows.empty()) {
        ImGui::TextWrapped("No two pairs of elements stand in the same relation to each other.");
        return actions;
    }
    if (!table.complete) ImGui::TextWrapped("Only the most frequent ones are shown: the drawing has more.");
    constexpr ImGuiTableFlags flags = ImGuiTableFlags_ScrollX | ImGuiTableFlags_ScrollY | ImGuiTableFlags_SizingFixedFit |
                                      ImGuiTableFlags_RowBg | ImGuiTableFlags_Resizable | ImGuiTableFlags_BordersOuter |
                                      ImGuiTableFlags_Sortable;
    constexpr float rows_seen = 10;
    if (!ImGui::BeginTable("clusters", columns, flags, {0, rows_seen * ImGui::GetTextLineHeightWithSpacing()}))
        return actions;
    set_up_columns();
    const RankedClusters ranked = ranked_clusters(table, shown_document(state).analysis.weights);
    const std::vector<std::size_t> order = sorted_rows(table, ranked);
    int hovered = -1;
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(order.size()));
    while (clipper.Step()) {
        for (int k = clipper.DisplayStart; k < clipper.DisplayEnd; ++k) {
            const std::size_t row = order[static_cast<std::size_t>(k)];
            if (show_row(state, tools, k, row, ranked.importance[row], actions)) hovered = static_cast<int>(row);
        }
    }
    ImGui::EndTable();
    if (hovered != state.clusters.hovered) actions.push_back(AnalysisAction{HoverCluster{hovered}});
    return actions;
}

}  // namespace rinceau
