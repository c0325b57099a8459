// A transformation space as two scatter plots, as in Stava et al. 2010.

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "editor/panels/analysis_parts.h"
#include "geometry/angle.h"

namespace rinceau {
namespace {

/// The values of a side of a plot.
struct PlotAxis {
    double low = 0, high = 1;
    float share(double value) const { return static_cast<float>((value - low) / (high - low)); }
};

PlotAxis axis_of(const std::vector<double>& values) {
    constexpr double air = 0.05;  // of the range, on both ends
    const auto [low, high] = std::ranges::minmax(values);
    const double range = high > low ? high - low : std::max(1.0, std::abs(high));
    return {low - air * range, high + air * range};
}

struct ScatterPlot {
    const char* name;
    const char* caption;
    std::vector<double> angles;  ///< radians
    std::vector<double> values;
};

/// The point of the plot under the mouse, if there is one, after it was drawn.
std::optional<std::size_t> draw(const ScatterPlot& plot, const ClusteredSpace& clustered, int lit_cluster, ImVec2 size) {
    ImGui::InvisibleButton(plot.name, size);
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, high, ImGui::GetColorU32(ImGuiCol_FrameBg));
    list.AddRect(low, high, ImGui::GetColorU32(ImGuiCol_Border));
    list.AddText({low.x + ImGui::GetStyle().FramePadding.x, low.y}, ImGui::GetColorU32(ImGuiCol_TextDisabled), plot.caption);
    const PlotAxis across{-pi, pi};
    const PlotAxis up = axis_of(plot.values);
    const float radius = ImGui::GetFontSize() / 7;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const bool over = ImGui::IsItemHovered();
    std::optional<std::size_t> nearest;
    float least = 4 * radius * radius;  // reach of the mouse, squared
    for (std::size_t k = 0; k < plot.angles.size(); ++k) {
        const ImVec2 at{low.x + across.share(plot.angles[k]) * size.x, high.y - up.share(plot.values[k]) * size.y};
        const int cluster = clustered.clusters.cluster_of[k];
        const unsigned color = cluster_color(cluster);
        constexpr int corners = 8;
        if (clustered.space.points[k].mirrored) {
            list.AddCircle(at, radius, color, corners);
        } else {
            list.AddCircleFilled(at, radius, color, corners);
        }
        if (cluster == lit_cluster) list.AddCircle(at, 1.6F * radius, ImGui::GetColorU32(ImGuiCol_Text), corners);
        const float apart = (at.x - mouse.x) * (at.x - mouse.x) + (at.y - mouse.y) * (at.y - mouse.y);
        if (over && apart < least) {
            least = apart;
            nearest = k;
        }
    }
    return nearest;
}

/// The row of a cluster of a space; -1 = the table has none.
int row_of(const ClusterTable& table, int space, int cluster) {
    const auto found = std::ranges::find_if(
        table.rows, [&](const ClusterRow& row) { return row.space == space && row.cluster == cluster; });
    return found == table.rows.end() ? -1 : static_cast<int>(found - table.rows.begin());
}

/// Plots of more points are drawn thinner, so that a frame stays quick.
constexpr std::size_t most_drawn = 6000;

ClusteredSpace thinned(const ClusteredSpace& whole) {
    const std::size_t count = whole.space.points.size();
    if (count <= most_drawn) return whole;
    ClusteredSpace thin{{whole.space.from, whole.space.to, {}}, {whole.clusters.clusters, {}}};
    const std::size_t stride = (count + most_drawn - 1) / most_drawn;
    for (std::size_t k = 0; k < count; k += stride) {
        thin.space.points.push_back(whole.space.points[k]);
        thin.clusters.cluster_of.push_back(whole.clusters.cluster_of[k]);
    }
    return thin;
}

}  // namespace

Actions space_plots(const EditorState& state, const PanelTools& tools) {
    Actions actions;
    const ClustersState& clusters = state.clusters;
    const ClusterTable& table = clusters.found->table;
    if (table.rows.empty()) return actions;
    // The space of what is pointed at or kept, else of the first row.
    const int shown = clusters.hovered >= 0 ? clusters.hovered : std::max(0, clusters.kept);
    const ClusterRow& row = table.rows[static_cast<std::size_t>(shown)];
    const ClusteredSpace clustered = thinned(table.spaces[static_cast<std::size_t>(row.space)]);
    ScatterPlot place{"place", "\xce\xb1 \xe2\x86\x92 d", {}, {}};
    ScatterPlot shape{"shape", "\xce\xb2 \xe2\x86\x92 s", {}, {}};
    for (const TransformationPoint& point : clustered.space.points) {
        place.angles.push_back(point.alpha);
        place.values.push_back(point.d);
        shape.angles.push_back(point.beta);
        shape.values.push_back(std::log(point.s));
    }
    ImGui::Text("%s to %s: %d pairs in %d clusters", table.names[static_cast<std::size_t>(clustered.space.from)].c_str(),
                table.names[static_cast<std::size_t>(clustered.space.to)].c_str(),
                static_cast<int>(table.spaces[static_cast<std::size_t>(row.space)].space.points.size()),
                static_cast<int>(clustered.clusters.clusters.size()));
    const float width = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2;
    if (width < 1) return actions;
    constexpr float height_of_width = 0.75F;
    const ImVec2 size{width, height_of_width * width};
    std::optional<std::size_t> over = draw(place, clustered, row.cluster, size);
    bool clicked = ImGui::IsItemClicked();
    note_place(tools, "analysis/Plot of places");
    ImGui::SameLine();
    if (const auto other = draw(shape, clustered, row.cluster, size)) over = other;
    clicked = clicked || ImGui::IsItemClicked();
    note_place(tools, "analysis/Plot of shapes");
    if (!over) return actions;
    const int cluster = row_of(table, row.space, clustered.clusters.cluster_of[*over]);
    const TransformationPoint& point = clustered.space.points[*over];
    ImGui::SetTooltip("\xce\xb1 %.4g\xc2\xb0, d %.4g, s %.4g, \xce\xb2 %.4g\xc2\xb0%s", degrees(point.alpha), point.d,
                      point.s, degrees(point.beta), cluster < 0 ? "\nalone: no other pair stands like this" : "");
    if (clicked && cluster >= 0 && cluster != clusters.kept) actions.push_back(AnalysisAction{KeepCluster{cluster}});
    return actions;
}

}  // namespace rinceau
