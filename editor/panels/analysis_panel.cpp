// The analysis and how far it is.

#include <imgui.h>

#include "editor/panels/panel.h"

namespace rinceau {

Actions analysis_panel(const EditorState& state, const PanelTools& tools) {
    Actions actions;
    if (state.analysis.running) {
        ImGui::ProgressBar(static_cast<float>(state.analysis.fraction), {-1, 0}, state.analysis.stage.c_str());
        if (ImGui::Button("Stop")) actions.push_back(AnalysisAction{CancelAnalysis{}});
        note_place(tools, "analysis/Stop");
        return actions;
    }
    ImGui::BeginDisabled(!state.document.drawing);
    if (ImGui::Button("Analyse")) actions.push_back(AnalysisAction{StartAnalysis{state.document.analysis}});
    note_place(tools, "analysis/Analyse");
    ImGui::EndDisabled();
    return actions;
}

}  // namespace rinceau
