// Noise: by kind, and on single numbers.

#include <imgui.h>

#include <cstdint>

#include "editor/model/tool_view.h"
#include "editor/panels/tools_panel.h"

namespace rinceau {
namespace {

/// How a kind of noise is shown, dragged and begun with.
struct NoiseField {
    const char* label;
    const char* format;
    double shown_unit;    ///< of the spread
    float drag_step;      ///< shown units a pixel
    double usual_spread;  ///< shown units
};

constexpr NoiseField angle_field{"angle", "%.1f deg", 1, 0.1F, 5};
constexpr NoiseField distance_field{"distance", "%.1f %%", 0.01, 0.1F, 10};
constexpr NoiseField scale_field{"scale", "%.1f %%", 0.01, 0.1F, 10};

const char* distribution_label(const Noise& noise) {
    if (noise.spread == 0) return "none";
    return noise.distribution == NoiseDistribution::normal ? "normal" : "uniform";
}

bool distribution_combo(const PanelTools& tools, const std::string& name, const NoiseField& field, Noise& noise) {
    constexpr float combo_ems = 5.5F;
    ImGui::SetNextItemWidth(combo_ems * ImGui::GetFontSize());
    const bool open = ImGui::BeginCombo("##distribution", distribution_label(noise));
    note_place(tools, name + " kind");
    if (!open) return false;
    const double spread = noise.spread > 0 ? noise.spread : field.usual_spread * field.shown_unit;
    bool changed = false;
    for (const Noise& choice : {Noise{noise.distribution, 0}, Noise{NoiseDistribution::normal, spread},
                                Noise{NoiseDistribution::uniform, spread}}) {
        const char* label = distribution_label(choice);
        if (ImGui::Selectable(label, choice == noise)) {
            noise = choice;
            changed = true;
        }
        note_place(tools, name + " kind/" + label);
    }
    ImGui::EndCombo();
    return changed;
}

/// Combo and spread of one noise; true = it was changed.
bool noise_fields(const PanelTools& tools, const std::string& name, const NoiseField& field, const char* label,
                  Noise& noise) {
    ImGui::PushID(label);
    bool changed = distribution_combo(tools, name, field, noise);
    ImGui::SameLine();
    double shown = noise.spread / field.shown_unit;
    constexpr double least = 0;
    constexpr double most = 1000;
    if (ImGui::DragScalar(label, ImGuiDataType_Double, &shown, field.drag_step, &least, &most, field.format,
                          ImGuiSliderFlags_AlwaysClamp)) {
        noise.spread = shown * field.shown_unit;
        changed = true;
    }
    note_place(tools, name);
    ImGui::PopID();
    return changed;
}

void kind_fields(const PanelTools& tools, const NoiseField& field, const std::optional<Noise>& shown,
                 std::optional<double>& spread, NoiseDistribution& distribution, bool& changed) {
    Noise noise = shown.value_or(Noise{});
    if (!noise_fields(tools, std::string("tools/Randomize ") + field.label, field, field.label, noise)) return;
    spread = noise.spread;
    distribution = noise.distribution;
    changed = true;
}

const NoiseField& field_of(NumberKind kind) {
    if (kind == NumberKind::angle) return angle_field;
    return kind == NumberKind::scale ? scale_field : distance_field;
}

void single_numbers(const EditorState& state, const PanelTools& tools, RandomizeOptions& noise, bool& changed) {
    const bool open = ImGui::TreeNode("Single numbers");
    note_place(tools, "tools/Single numbers");
    if (!open) return;
    if (!state.rules.sheet) return ImGui::TreePop();
    const Grammar& grammar = *state.rules.sheet->grammar;
    for (const GrammarNumber& number : state.rules.sheet->numbers) {
        if (number.rank > NumberRank::axiom || !takes_noise(number)) continue;
        const auto set = noise.named.find(number.name);
        Noise shown = set != noise.named.end() ? set->second : noise_on(grammar, number).value_or(Noise{});
        if (!noise_fields(tools, "tools/Randomize " + number.name, field_of(number.kind), number.name.c_str(), shown))
            continue;
        noise.named[number.name] = shown;
        changed = true;
    }
    ImGui::TreePop();
}

void seed_field(const EditorState& state, const PanelTools& tools, RandomizeOptions& noise, bool& changed,
                Actions& actions) {
    std::uint64_t seed = shown_seed(state);
    if (ImGui::InputScalar("seed", ImGuiDataType_U64, &seed)) {
        noise.seed = seed;
        changed = true;
    }
    note_place(tools, "tools/Seed");
    if (ImGui::Button("New seed")) actions.push_back(ToolsAction{NewSeed{}});
    note_place(tools, "tools/New seed");
}

}  // namespace

void randomize_section(const EditorState& state, const PanelTools& tools, Actions& actions) {
    if (!tool_header(state, tools, ToolSection::randomize, "Randomize", actions)) return;
    RandomizeOptions noise = state.tools.settings.noise;
    const NoiseInGrammar shown = shown_noise(state);
    bool changed = false;
    kind_fields(tools, angle_field, shown.angle, noise.angle, noise.angle_distribution, changed);
    kind_fields(tools, distance_field, shown.distance, noise.distance, noise.distance_distribution, changed);
    kind_fields(tools, scale_field, shown.scale, noise.scale, noise.scale_distribution, changed);
    single_numbers(state, tools, noise, changed);
    seed_field(state, tools, noise, changed, actions);
    if (changed) actions.push_back(ToolsAction{SetNoise{noise}});
    ImGui::SameLine();
    if (ImGui::Button("Randomize")) actions.push_back(ToolsAction{UseTool{shared_edit(RandomizeEdit{noise})}});
    note_place(tools, "tools/Randomize");
}

}  // namespace rinceau
