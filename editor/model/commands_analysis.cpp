// Commands of the menu Analysis.

#include "editor/model/command.h"
#include "editor/model/wished_analysis.h"

namespace rinceau {
namespace {

bool has_drawing(const EditorState& state) { return state.document.drawing != nullptr; }

/// Analyses with the options that are wished, changed.
template <class Change>
Action start_with(const EditorState& state, const Change& change) {
    AnalyzeOptions options = wished_analysis(state);
    change(options);
    return AnalysisAction{StartAnalysis{options}};
}

Command command(std::string name, std::string label, std::string help, Action (*action)(const EditorState&)) {
    return {.name = std::move(name),
            .menu = "Analysis",
            .label = std::move(label),
            .shortcut = "",
            .help = std::move(help),
            .enabled = has_drawing,
            .action = action};
}

}  // namespace

std::vector<Command> analysis_commands() {
    Command run = command("analysis.run", "Analyse", "Looks for the rules behind the drawing anew.",
                          [](const EditorState& state) { return start_with(state, [](AnalyzeOptions&) {}); });
    run.shortcut = "Ctrl+Shift+A";
    Command stop = command("analysis.stop", "Stop the analysis", "The rules stay as they were before.",
                           [](const EditorState&) -> Action { return AnalysisAction{CancelAnalysis{}}; });
    stop.enabled = [](const EditorState& state) { return state.analysis.running; };
    return {
        std::move(run),
        std::move(stop),
        command("analysis.defaults", "Analyse with the default settings",
                "Tolerance, similarity, weights and switches as they are at first; groups made by hand stay.",
                [](const EditorState& state) -> Action { return AnalysisAction{StartAnalysis{default_analysis(state)}}; }),
        command("analysis.objective", "Weigh by bits or as the paper",
                "Switches between the shortest description and the paper's importance.",
                [](const EditorState& state) {
                    return start_with(state, [](AnalyzeOptions& options) {
                        options.objective = options.objective == Objective::bits ? Objective::paper : Objective::bits;
                    });
                }),
        command("analysis.symmetrize", "Regular layout", "Switches whether the regular layout behind the drawing is drawn.",
                [](const EditorState& state) {
                    return start_with(state, [](AnalyzeOptions& options) { set_symmetrize(options, !options.symmetrize); });
                }),
        command("analysis.stochastic", "Noise instead of exceptions",
                "Switches whether the rules get noise of the size that elements miss their places by.",
                [](const EditorState& state) {
                    return start_with(state, [](AnalyzeOptions& options) { set_stochastic(options, !options.stochastic); });
                }),
        command("analysis.mirrored", "Mirrored copies", "Switches whether a mirror image counts as the same shape.",
                [](const EditorState& state) {
                    return start_with(state, [](AnalyzeOptions& options) {
                        options.similarity.mirrored_copies = !options.similarity.mirrored_copies;
                    });
                }),
    };
}

}  // namespace rinceau
