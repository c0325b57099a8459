// Arrangement by example: how it grows, brushes and strokes, priorities, jitter.

#include <imgui.h>

#include <string>

#include "editor/model/growth_source.h"
#include "editor/model/growth_view.h"
#include "editor/panels/growth_parts.h"

namespace rinceau {
namespace {

constexpr double most_at_once = 100'000;
constexpr double largest_canvas = 20;

void how_much(GrowthForm& form) {
    ArrangementSettings& settings = form.settings.arrangement;
    int turn = static_cast<int>(settings.turn);
    form.choice("turn", turn, {"as they stand", "to fit", "along the flow"},
                "How elements are turned: as in the drawing; so that their neighbours fit best; along flow strokes.");
    settings.turn = static_cast<ElementTurn>(turn);
    int fill = settings.fill ? 1 : 0;
    form.choice("until", fill, {"a number stands", "the canvas is full"},
                "When growth ends. Within a full canvas all elements stand whole.");
    settings.fill = fill == 1;
    if (!settings.fill)
        form.count("elements more", settings.count, 1, static_cast<std::size_t>(most_at_once), "How many grow at once.");
    constexpr float step = 0.02F;
    form.number("canvas", settings.canvas, 0.5, largest_canvas, step, "%.2f x",
                "Its width and height beside the drawing's.");
    form.seed(settings.seed);
    form.check("finish", settings.finish, "At the end all is relaxed, gaps are filled and overlaps taken away.");
}

void growing(GrowthForm& form) {
    const std::string label = form.settings.arrangement.fill
                                  ? "Fill the canvas"
                                  : "Grow " + std::to_string(form.settings.arrangement.count) + " elements";
    if (ImGui::Button((label + "##grow").c_str())) form.actions.push_back(GrowthAction{BeginGrowth{}});
    note_place(form.tools(), "growth/Grow");
    ImGui::SameLine();
    form.command("growth.other_seed");
    form.command("growth.more");
    ImGui::SameLine();
    form.command("growth.relax");
    ImGui::SameLine();
    form.command("growth.finish");
}

void brush_button(GrowthForm& form, const char* label, GrowthBrush brush, const char* name) {
    const bool taken = brush_on_canvas(form.state()) == brush;
    if (taken) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
    if (ImGui::Button(label)) form.actions.push_back(GrowthAction{TakeBrush{brush}});
    if (taken) ImGui::PopStyleColor();
    note_place(form.tools(), std::string("growth/") + name);
}

void strokes_row(GrowthForm& form, const char* what, std::size_t count, GrowthBrush brush) {
    const std::string name = std::string("growth/") + what;
    ImGui::PushID(what);
    ImGui::BeginDisabled(count == 0);
    if (ImGui::Button("Erase last")) form.actions.push_back(GrowthAction{EraseStrokes{brush, false}});
    note_place(form.tools(), name + " erase last");
    ImGui::SameLine();
    if (ImGui::Button("all")) form.actions.push_back(GrowthAction{EraseStrokes{brush, true}});
    note_place(form.tools(), name + " erase all");
    ImGui::EndDisabled();
    ImGui::SameLine();
    ImGui::Text("%zu %s", count, what);
    ImGui::PopID();
}

void brushes(GrowthForm& form) {
    ImGui::Separator();
    ImGui::TextDisabled("Drag on the canvas:");
    brush_button(form, "Spray", GrowthBrush::spray, "Spray");
    ImGui::SameLine();
    brush_button(form, "Flow", GrowthBrush::flow, "Flow");
    ImGui::SameLine();
    brush_button(form, "Boundary", GrowthBrush::boundary, "Boundary");
    ImGui::SameLine();
    brush_button(form, "Flip edges", GrowthBrush::flip, "Flip edges");
    constexpr float step = 0.05F;
    form.number("brush", form.settings.arrangement.brush, 1, 50, step, "%.1f elements", "Radius of the spray.");
    strokes_row(form, "flow strokes", form.state().growth.guides->flow.size(), GrowthBrush::flow);
    strokes_row(form, "boundary strokes", form.state().growth.guides->boundary.size(), GrowthBrush::boundary);
    form.check("strokes have a direction", form.settings.arrangement.directed,
               "Elements face where a flow stroke was drawn to; else they only lie along it.");
    form.check("neighbours", form.settings.edges, "Lines between elements that are neighbours.");
    ImGui::SameLine();
    form.command("growth.forget_flips");
}

void priorities(GrowthForm& form) {
    const bool open = ImGui::CollapsingHeader("Priorities");
    note_place(form.tools(), "growth/Priorities");
    if (!open) return;
    const GrowthSource* source = current_source(form.state());
    if (source == nullptr || !source->exemplar) return;
    ImGui::TextWrapped("Kinds with a higher number grow first.");
    for (const ExemplarSymbol& symbol : source->exemplar->symbols) {
        int priority = 0;
        const auto set = form.settings.arrangement.priorities.find(symbol.name);
        if (set != form.settings.arrangement.priorities.end()) priority = set->second;
        const int before = priority;
        constexpr int most = 9;
        form.whole((symbol.name + "##priority").c_str(), priority, 0, most, "Of this kind of element.");
        if (priority != before) form.settings.arrangement.priorities[symbol.name] = priority;
    }
}

void jitter(GrowthForm& form) {
    const bool open = ImGui::CollapsingHeader("Jitter");
    note_place(form.tools(), "growth/Jitter");
    if (!open) return;
    JitterSettings& settings = form.settings.arrangement.jitter;
    constexpr float degrees = 0.2F;
    constexpr float percent = 0.002F;
    form.number("angle", settings.angle, 0, 180, degrees, "%.1f deg", "By how much each element is turned, at most.");
    form.number("size", settings.scale, 0, 1, percent, "%.3f",
                "By which share each is larger or smaller, at most; less where it would cross another one.");
    form.number("colour", settings.color, 0, 1, percent, "%.3f", "How far each has another hue and lightness, at most.");
}

}  // namespace

void growth_arrangement(GrowthForm& form) {
    how_much(form);
    growing(form);
    brushes(form);
    priorities(form);
    jitter(form);
    form.check("compare two rings", form.settings.arrangement.two_rings,
               "Neighbours of neighbours count, too: copies the drawing more closely.");
}

}  // namespace rinceau
