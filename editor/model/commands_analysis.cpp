// Commands of the menu Analysis.

#include "editor/model/command.h"

namespace rinceau {

std::vector<Command> analysis_commands() {
    return {
        {.name = "analysis.run",
         .menu = "Analysis",
         .label = "Analyse",
         .shortcut = "",
         .help = "Looks for the rules behind the drawing anew.",
         .enabled = [](const EditorState& state) { return state.document.drawing != nullptr; },
         .action = [](const EditorState& state) -> Action {
             return AnalysisAction{StartAnalysis{state.document.analysis}};
         }},
    };
}

}  // namespace rinceau
