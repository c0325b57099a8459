// Growth: more of the same from the document, by example or packed densely.

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <utility>

#include "editor/model/grown_pattern.h"
#include "editor/model/growth_view.h"
#include "editor/panels/command_menu.h"
#include "editor/panels/growth_parts.h"

namespace rinceau {

void GrowthForm::look(const char* label, bool changed, const char* help) {
    note_place(tools_, std::string("growth/") + label);
    tooltip(help);
    changed_ = changed_ || changed;
}

void GrowthForm::number(const char* label, double& value, double low, double high, float step, const char* format,
                        const char* help) {
    const bool changed =
        ImGui::DragScalar(label, ImGuiDataType_Double, &value, step, &low, &high, format, ImGuiSliderFlags_AlwaysClamp);
    look(label, changed, help);
}

void GrowthForm::whole(const char* label, int& value, int low, int high, const char* help) {
    constexpr float step = 0.05F;
    const bool changed = ImGui::DragInt(label, &value, step, low, high, "%d", ImGuiSliderFlags_AlwaysClamp);
    look(label, changed, help);
}

void GrowthForm::count(const char* label, std::size_t& value, std::size_t low, std::size_t high, const char* help) {
    const float step = std::max(1.0F, static_cast<float>(value) / 100);
    std::uint64_t shown = value;
    const std::uint64_t least = low;
    const std::uint64_t most = high;
    const bool changed =
        ImGui::DragScalar(label, ImGuiDataType_U64, &shown, step, &least, &most, nullptr, ImGuiSliderFlags_AlwaysClamp);
    value = shown;
    look(label, changed, help);
}

void GrowthForm::seed(std::uint64_t& value) {
    look("seed", ImGui::InputScalar("seed", ImGuiDataType_U64, &value), "The same seed and settings give the same result.");
}

void GrowthForm::check(const char* label, bool& value, const char* help) {
    look(label, ImGui::Checkbox(label, &value), help);
}

void GrowthForm::text(const char* label, std::string& value, const char* help) {
    look(label, ImGui::InputText(label, &value), help);
}

bool GrowthForm::file(const char* label, std::string& value, const char* button, const char* help) {
    const std::string shown = std::string(button) + "##" + label;
    const float room =
        ImGui::CalcTextSize(button).x + 2 * ImGui::GetStyle().FramePadding.x + ImGui::GetStyle().ItemSpacing.x;
    ImGui::SetNextItemWidth(std::max(1.0F, ImGui::CalcItemWidth() - room));
    const std::string hidden = std::string("##") + label;
    const bool changed = ImGui::InputText(hidden.c_str(), &value);
    const bool entered = ImGui::IsItemDeactivatedAfterEdit() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter));
    look(label, changed, help);
    ImGui::SameLine();
    ImGui::BeginDisabled(value.empty());
    const bool pressed = ImGui::Button(shown.c_str());
    ImGui::EndDisabled();
    note_place(tools_, std::string("growth/") + button + ' ' + label);
    ImGui::SameLine();
    ImGui::TextUnformatted(label);
    return (entered || pressed) && !value.empty();
}

void GrowthForm::choice(const char* label, int& value, const std::vector<const char*>& labels, const char* help) {
    const bool open = ImGui::BeginCombo(label, labels[static_cast<std::size_t>(value)]);
    note_place(tools_, std::string("growth/") + label);
    if (!open) return tooltip(help);
    for (int i = 0; i < static_cast<int>(labels.size()); ++i) {
        const char* one = labels[static_cast<std::size_t>(i)];
        if (ImGui::Selectable(one, i == value)) {
            value = i;
            changed_ = true;
        }
        note_place(tools_, std::string("growth/") + label + '/' + one);
    }
    ImGui::EndCombo();
}

void GrowthForm::command(const char* name) {
    if (const Command* known = find_command(name)) command_button(*known, "growth", state_, tools_, actions);
}

Actions GrowthForm::done() {
    // settings first: a button that was pressed means them as they are now
    if (!changed_) return std::move(actions);
    const bool on_surface = settings.tab == GrowthTab::surface;
    actions.insert(actions.begin(),
                   on_surface ? Action{SurfaceAction{SetSurface{surface}}} : GrowthAction{SetGrowth{settings}});
    return std::move(actions);
}

namespace {

void tabs(GrowthForm& form) {
    const auto tab = [&](const char* label, GrowthTab which) {
        if (ImGui::RadioButton(label, form.settings.tab == which)) form.actions.push_back(GrowthAction{OpenGrowth{which}});
        note_place(form.tools(), std::string("growth/tab ") + label);
    };
    tab("Arrangement", GrowthTab::arrangement);
    ImGui::SameLine();
    tab("Aggregate", GrowthTab::aggregate);
    ImGui::SameLine();
    tab("Surface", GrowthTab::surface);
}

const char* work_in_words(const GrowthState& growth) {
    if (growth.stopping) return "stopping";
    switch (growth.work) {
        case GrowthWork::arranging:
            return "growing";
        case GrowthWork::filling:
            return "filling";
        case GrowthWork::using_it:
            return "writing rules";
        case GrowthWork::none:
            break;
    }
    return growth.asked ? "finding elements" : growth.grown ? growth.grown->told.c_str() : "";
}

/// As high whether something grows or not, so that nothing below jumps.
void progress_row(GrowthForm& form) {
    const GrowthState& growth = form.state().growth;
    const bool works = growth.work != GrowthWork::none;
    ImGui::BeginDisabled(!works);
    if (ImGui::Button("Stop")) form.actions.push_back(GrowthAction{StopGrowth{}});
    ImGui::EndDisabled();
    note_place(form.tools(), "growth/Stop");
    tooltip("What has grown until now stays (Esc)");
    ImGui::SameLine();
    ImGui::ProgressBar(works ? static_cast<float>(growth.fraction) : 0, {-1, 0}, work_in_words(growth));
    note_place(form.tools(), "growth/Progress");
}

void result_row(GrowthForm& form) {
    form.command("growth.use");
    ImGui::SameLine();
    const bool can_return = !form.state().growth.grown && form.state().growth.dropped;
    if (can_return) {
        form.command("growth.bring_back");
        return;
    }
    ImGui::BeginDisabled(!form.state().growth.grown);
    if (ImGui::Button("Clear")) form.actions.push_back(GrowthAction{DropGrowth{}});
    note_place(form.tools(), "growth/Clear");
    ImGui::SameLine();
    bool shown = shows_grown(form.state());
    if (ImGui::Checkbox("shown", &shown)) form.actions.push_back(GrowthAction{ShowGrowth{shown}});
    note_place(form.tools(), "growth/shown");
    ImGui::EndDisabled();
    tooltip("On the canvas: what has grown, or the drawing");
}

void raised_choice(GrowthForm& form) {
    const std::vector<std::string> symbols = symbols_to_raise(*form.state().document.resolved);
    std::vector<const char*> labels{"what touches is one"};
    labels.push_back("each shape");
    int chosen = form.settings.group ? 0 : 1;
    for (std::size_t i = 0; i < symbols.size(); ++i) {
        labels.push_back(symbols[i].c_str());
        if (symbols[i] == form.settings.raised) chosen = static_cast<int>(i) + 2;
    }
    const int before = chosen;
    form.choice("elements", chosen, labels,
                "What is one element: shapes that touch each other, every shape by itself, or all that a rule draws.");
    if (chosen == before) return;
    form.settings.group = chosen != 1;
    form.settings.raised = chosen < 2 ? std::string() : symbols[static_cast<std::size_t>(chosen) - 2];
}

void source_facts(GrowthForm& form) {
    const GrowthSource* source = current_source(form.state());
    if (source == nullptr) return ImGui::TextDisabled("Elements are being found ..");
    const bool needs_exemplar = form.settings.tab == GrowthTab::arrangement;
    if (needs_exemplar ? source->exemplar != nullptr : source->drawing != nullptr) {
        const std::size_t kinds = needs_exemplar ? source->exemplar->symbols.size() : source->drawing->figures.size();
        const std::size_t elements = source->drawing->instances.size();
        ImGui::TextDisabled("%zu %s of %zu %s%s", elements, elements == 1 ? "element" : "elements", kinds,
                            kinds == 1 ? "kind" : "kinds", source->tile ? ", a tile" : "");
    } else {
        ImGui::TextWrapped("%s", source->mistake.c_str());
    }
    note_place(form.tools(), "growth/source");
}

}  // namespace

Actions growth_panel(const EditorState& state, const PanelTools& tools) {
    constexpr float room_for_labels = 8;  // widths of a letter
    GrowthForm form(state, tools);
    tabs(form);
    if (form.settings.tab == GrowthTab::surface) {
        growth_surface(form);
        return form.done();
    }
    if (state.document.resolved->terminals.empty()) {
        ImGui::TextWrapped("Open a drawing with some elements: more of the same can then grow from it.");
        return form.done();
    }
    progress_row(form);
    result_row(form);
    ImGui::Separator();
    ImGui::PushItemWidth(-room_for_labels * ImGui::GetFontSize());
    raised_choice(form);
    source_facts(form);
    ImGui::Separator();
    if (form.settings.tab == GrowthTab::arrangement) {
        growth_arrangement(form);
    } else {
        growth_aggregate(form);
    }
    ImGui::PopItemWidth();
    return form.done();
}

}  // namespace rinceau
