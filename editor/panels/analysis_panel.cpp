// The analysis: what it shall look for, how far it is, what it found.

#include <imgui.h>

#include "editor/model/analysis_words.h"
#include "editor/model/wished_analysis.h"
#include "editor/panels/analysis_parts.h"

namespace rinceau {
namespace {

constexpr double largest_tolerance = 0.1;  // element sizes; looser ones join what nobody sees together
constexpr double least_similarity = 1e-4;  // sizes
constexpr double largest_similarity = 0.2;
constexpr double largest_weight = 4;

/// What the settings were before a widget, and what it makes of them.
class Settings {
  public:
    Settings(const EditorState& state, const PanelTools& tools, Actions& actions)
        : state_(state), options_(wished_analysis(state)), tools_(tools), actions_(actions) {}

    const AnalyzeOptions& options() const { return options_; }

    /// A slider: followed while it moves, meant when it is let go.
    void slider(const char* label, double value, double low, double high, const char* format, ImGuiSliderFlags flags,
                const char* help, void (*set)(AnalyzeOptions&, double)) {
        const bool changed = ImGui::SliderScalar(label, ImGuiDataType_Double, &value, &low, &high, format,
                                                 flags | ImGuiSliderFlags_AlwaysClamp);
        note_place(tools_, std::string("analysis/") + label);
        if (ImGui::IsItemHovered() && !ImGui::IsItemActive()) ImGui::SetTooltip("%s", help);
        set(options_, value);
        if (changed) actions_.push_back(AnalysisAction{TryAnalysis{options_}});
        if (ImGui::IsItemActive() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape)))
            actions_.push_back(RulesAction{DropPreview{}});
        // Esc may have dropped what was tried: then there is nothing to begin.
        if (ImGui::IsItemDeactivatedAfterEdit() && (state_.preview || state_.analysis.running || changed))
            actions_.push_back(AnalysisAction{StartAnalysis{options_}});
    }

    void choice(const char* label, bool on, const char* help, void (*set)(AnalyzeOptions&, bool)) {
        const bool changed = ImGui::Checkbox(label, &on);
        note_place(tools_, std::string("analysis/") + label);
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", help);
        if (!changed) return;
        set(options_, on);
        actions_.push_back(AnalysisAction{StartAnalysis{options_}});
    }

  private:
    const EditorState& state_;
    AnalyzeOptions options_;
    const PanelTools& tools_;
    Actions& actions_;
};

void how_alike(Settings& settings) {
    const AnalyzeOptions& options = settings.options();
    settings.slider("Tolerance", options.tolerance, 0, largest_tolerance, options.tolerance > 0 ? "%.4f" : "automatic", 0,
                    "By how much of its size an element may miss its place in a rule. 0: several are tried and the "
                    "shortest rules are kept.",
                    [](AnalyzeOptions& o, double value) { o.tolerance = value; });
    settings.slider("Similarity", options.similarity.tolerance, least_similarity, largest_similarity, "%.4f",
                    ImGuiSliderFlags_Logarithmic,
                    "By how much of their size two outlines may differ and still count as copies. What can be seen is "
                    "kept apart whatever this is.",
                    [](AnalyzeOptions& o, double value) { o.similarity.tolerance = value; });
}

void weights(Settings& settings) {
    const ImportanceWeights& weights = settings.options().weights;
    settings.slider("Count weight", weights.count, 0, largest_weight, "%.2f", 0, "w_n: prefers what repeats often.",
                    [](AnalyzeOptions& o, double value) { o.weights.count = value; });
    settings.slider("Nearness weight", weights.nearness, 0, largest_weight, "%.2f", 0,
                    "w_h: prefers to join what is near to each other.",
                    [](AnalyzeOptions& o, double value) { o.weights.nearness = value; });
    settings.slider("Similarity weight", weights.similarity, 0, largest_weight, "%.2f", 0,
                    "w_phi: prefers what repeats exactly.",
                    [](AnalyzeOptions& o, double value) { o.weights.similarity = value; });
    settings.slider("Length weight", weights.length, 0, largest_weight, "%.2f", 0, "w_l: prefers long sequences.",
                    [](AnalyzeOptions& o, double value) { o.weights.length = value; });
}

void choices(Settings& settings) {
    settings.choice("Importance of the paper", settings.options().objective == Objective::paper,
                    "Rules in the order of the paper's importance until nothing is left to join, instead of those that "
                    "make the description shorter.",
                    [](AnalyzeOptions& o, bool on) { o.objective = on ? Objective::paper : Objective::bits; });
    settings.choice("Regular layout", settings.options().symmetrize,
                    "Draws the regular layout behind the drawing: what elements miss their places by is dropped.",
                    set_symmetrize);
    settings.choice("Noise", settings.options().stochastic,
                    "Draws a relative of the drawing: rules get noise of the size that elements miss their places by.",
                    set_stochastic);
    settings.choice("Mirrored copies", settings.options().similarity.mirrored_copies,
                    "A mirror image counts as the same shape.",
                    [](AnalyzeOptions& o, bool on) { o.similarity.mirrored_copies = on; });
}

/// As high whether an analysis runs or not, so that nothing below jumps.
void progress_row(const EditorState& state, const PanelTools& tools, Actions& actions) {
    const AnalysisState& analysis = state.analysis;
    ImGui::BeginDisabled(!analysis.running);
    if (ImGui::Button("Stop")) actions.push_back(AnalysisAction{CancelAnalysis{}});
    ImGui::EndDisabled();
    note_place(tools, "analysis/Stop");
    ImGui::SameLine();
    const std::string text = analysis.running ? stage_in_words(analysis.stage) : state.document.report ? "done" : "";
    ImGui::ProgressBar(analysis.running ? static_cast<float>(analysis.fraction) : 0, {-1, 0}, text.c_str());
    note_place(tools, "analysis/Progress");
}

void summary(const AnalysisReport& report) {
    ImGui::TextWrapped("%s", analysis_summary(report).c_str());
    if (report.drawing_bits > 0)
        ImGui::Text("%.1f %% of the bits; tolerance %.4g", 100 * report.grammar_bits / report.drawing_bits,
                    report.tolerance);
    const AnalysisSeconds& seconds = report.seconds;
    ImGui::Text("%.2f s: shapes %.2f, rules %.2f, check %.2f", seconds.similarity + seconds.rules + seconds.verify,
                seconds.similarity, seconds.rules, seconds.verify);
    ImGui::TextWrapped("%s", report.check.summary.c_str());
    for (const std::string& warning : report.warnings) ImGui::TextWrapped("! %s", warning.c_str());
}

void add(Actions& all, Actions more) {
    for (Action& action : more) all.push_back(std::move(action));
}

bool section(const char* label, const PanelTools& tools, ImGuiTreeNodeFlags flags = 0) {
    const bool open = ImGui::CollapsingHeader(label, flags);
    note_place(tools, std::string("analysis/") + label);
    return open;
}

void clusters(const EditorState& state, const PanelTools& tools, Actions& actions) {
    const bool open = section("Clusters", tools);
    if (open != state.clusters.wanted) actions.push_back(AnalysisAction{ShowClusters{open}});
    if (!open) return;
    if (state.clusters.running) ImGui::TextUnformatted("finding clusters ...");
    if (!state.clusters.mistake.empty()) ImGui::TextWrapped("%s", state.clusters.mistake.c_str());
    if (!state.clusters.found) return;
    add(actions, clusters_table(state, tools));
    add(actions, space_plots(state, tools));
}

}  // namespace

Actions analysis_panel(const EditorState& state, const PanelTools& tools) {
    Actions actions;
    if (!state.document.drawing) {
        ImGui::TextWrapped("This document has no drawing to analyse. Open an .svg to see how its rules are found.");
        return actions;
    }
    Settings settings(state, tools, actions);
    if (ImGui::Button("Analyse")) actions.push_back(AnalysisAction{StartAnalysis{settings.options()}});
    note_place(tools, "analysis/Analyse");
    ImGui::SameLine();
    if (ImGui::Button("Defaults")) actions.push_back(AnalysisAction{StartAnalysis{default_analysis(state)}});
    note_place(tools, "analysis/Defaults");
    progress_row(state, tools, actions);
    if (section("Settings", tools, ImGuiTreeNodeFlags_DefaultOpen)) {
        constexpr float label_room = 9;  // in font sizes
        ImGui::PushItemWidth(-label_room * ImGui::GetFontSize());
        how_alike(settings);
        weights(settings);
        ImGui::PopItemWidth();
        choices(settings);
    }
    const auto& report = shown_document(state).report;
    if (report && section("Result", tools, ImGuiTreeNodeFlags_DefaultOpen)) {
        summary(*report);
        add(actions, found_rules(state, tools));
    }
    clusters(state, tools, actions);
    if (section("Groups by hand", tools)) add(actions, grouping_tools(state, tools));
    return actions;
}

}  // namespace rinceau
