// Aggregates: which shapes, where, how dense.

#include <imgui.h>

#include <algorithm>
#include <cstdint>
#include <string>

#include "editor/model/growth_source.h"
#include "editor/model/growth_view.h"
#include "editor/panels/growth_parts.h"

namespace rinceau {
namespace {

/// How the document draws a figure's first part; -1 = that is not known.
int look_of(const EditorState& state, const FiguredDrawing& drawing, const Figure& figure) {
    if (!state.picture || figure.parts.empty()) return -1;
    const auto& symbol = drawing.grammar.terminals[static_cast<std::size_t>(figure.parts.front().terminal)].symbol;
    const auto& looks = state.picture->looks;
    const auto found = std::ranges::find_if(looks, [&](const PictureLook& look) {
        return state.picture->grammar->terminals[static_cast<std::size_t>(look.terminal)].symbol == symbol;
    });
    return found == looks.end() ? -1 : static_cast<int>(found - looks.begin());
}

void thumbnail(GrowthForm& form, int look) {
    constexpr float lines = 1.6F;
    const float size = lines * ImGui::GetFontSize();
    const unsigned texture = look >= 0 && form.tools().thumbnail ? form.tools().thumbnail(look) : 0;
    if (texture == 0) {
        ImGui::Dummy({size, size});
    } else {
        ImGui::Image(reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(texture)), {size, size}, {0, 1}, {1, 0});
    }
    ImGui::SameLine();
}

void shape_row(GrowthForm& form, const FiguredDrawing& drawing, int index) {
    const Figure& figure = drawing.figures[static_cast<std::size_t>(index)];
    const auto set = form.settings.aggregate.shapes.find(index);
    ShapeChoice choice = set != form.settings.aggregate.shapes.end() ? set->second : ShapeChoice{};
    const std::string name = "growth/shape " + figure.symbol;
    ImGui::PushID(index);
    bool changed = ImGui::Checkbox("##used", &choice.used);
    note_place(form.tools(), name);
    ImGui::SameLine();
    thumbnail(form, look_of(form.state(), drawing, figure));
    constexpr float field = 4;  // widths of a letter
    ImGui::SetNextItemWidth(field * ImGui::GetFontSize());
    ImGui::BeginDisabled(!choice.used);
    constexpr double least = 0.01;
    constexpr double most = 1000;
    constexpr float step = 0.02F;
    changed = ImGui::DragScalar(figure.symbol.c_str(), ImGuiDataType_Double, &choice.share, step, &least, &most, "%.2f",
                                ImGuiSliderFlags_AlwaysClamp) ||
              changed;
    note_place(form.tools(), name + " share");
    ImGui::EndDisabled();
    ImGui::PopID();
    if (!changed) return;
    form.settings.aggregate.shapes[index] = choice;
    form.change();
}

void shapes(GrowthForm& form) {
    const GrowthSource* source = current_source(form.state());
    if (source == nullptr || !source->drawing) return;
    ImGui::TextDisabled("Shapes, and their shares:");
    constexpr int lines_at_most = 7;
    const int count = static_cast<int>(source->drawing->figures.size());
    const float line = ImGui::GetFrameHeightWithSpacing() + ImGui::GetStyle().ItemSpacing.y;
    const float height =
        line * static_cast<float>(std::clamp(count, 1, lines_at_most)) + 2 * ImGui::GetStyle().WindowPadding.y;
    if (ImGui::BeginChild("shapes", {0, height}, true)) {
        ImGuiListClipper clipper;
        clipper.Begin(count);
        while (clipper.Step())
            for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) shape_row(form, *source->drawing, i);
    }
    ImGui::EndChild();
    note_place(form.tools(), "growth/shapes");
}

void where(GrowthForm& form) {
    AggregateSettings& settings = form.settings.aggregate;
    constexpr float step = 0.02F;
    constexpr double largest = 50;
    form.text("region", settings.region, "An SVG file whose closed outlines are filled; nothing: the canvas");
    ImGui::BeginDisabled(!settings.region.empty());
    form.number("canvas", settings.canvas, 0.2, largest, step, "%.2f x", "Its width and height beside the drawing's.");
    form.check("tile", settings.tiled,
               "What leaves the canvas on one side comes in on the other: no seam when it is repeated.");
    ImGui::EndDisabled();
    form.text("density", settings.density,
              "A PNG file stretched over the canvas: dense where it is dark; nothing: dense everywhere");
}

void which_size(GrowthForm& form) {
    AggregateSettings& settings = form.settings.aggregate;
    constexpr double least = 0.01;
    constexpr double most = 100;
    constexpr float step = 0.01F;
    form.number("smallest", settings.min_scale, least, most, step, "%.2f x", "Least size of a shape beside the drawing's.");
    form.number("largest", settings.max_scale, least, most, step, "%.2f x",
                "Greatest size of a shape beside the drawing's.");
    if (settings.min_scale > settings.max_scale) {
        const bool raised = form.state().growth.settings.aggregate.max_scale == settings.max_scale;
        (raised ? settings.max_scale : settings.min_scale) = raised ? settings.min_scale : settings.max_scale;
    }
    const double far = diagonal(growth_canvas(form.state()));
    form.number("margin", settings.margin, -far, far, static_cast<float>(far) / 5000, "%.2f",
                "What shapes keep from each other.");
    form.check("fill holes", settings.keep_holes, "Shapes may stand in the holes of others.");
    int turn = static_cast<int>(settings.turn);
    form.choice("turned", turn, {"at random", "as they stand", "by quarters", "within"}, "Which angles shapes may have.");
    settings.turn = static_cast<PackTurn>(turn);
    if (settings.turn == PackTurn::within) {
        constexpr float degrees = 0.2F;
        form.number("spread", settings.spread, 0, 180, degrees, "%.1f deg", "To either side.");
    }
}

void how(GrowthForm& form) {
    AggregateSettings& settings = form.settings.aggregate;
    int method = static_cast<int>(settings.method);
    form.choice("method", method, {"settle", "gaps", "darts"},
                "Settle: slid and turned into gaps. Gaps: thrown where there is most room. Darts: thrown anywhere.");
    settings.method = static_cast<FillMethod>(method);
    int quality = static_cast<int>(settings.quality);
    form.choice("quality", quality, {"fast", "best"},
                "Best: shapes grow as far as they can, and all is shaken and filled again.");
    settings.quality = static_cast<FillQuality>(quality);
    form.seed(settings.seed);
}

}  // namespace

void growth_aggregate(GrowthForm& form) {
    form.command("growth.fill");
    ImGui::SameLine();
    form.command("growth.other_seed");
    shapes(form);
    where(form);
    which_size(form);
    how(form);
}

}  // namespace rinceau
