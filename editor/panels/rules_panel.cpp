// The rules: every number a drag field.

#include <imgui.h>

#include "editor/panels/panel.h"
#include "lsystem/numbers.h"

namespace rinceau {

Actions rules_panel(const EditorState& state, const PanelTools& tools) {
    Actions actions;
    for (const GrammarNumber& number : grammar_numbers(*shown_document(state).grammar)) {
        if (number.rank == NumberRank::hidden) continue;
        float value = static_cast<float>(number.value);
        const bool changed =
            ImGui::DragFloat(number.name.c_str(), &value, number.whole ? 0.1F : 0.5F, 0, 0, number.whole ? "%.0f" : "%.4g");
        note_place(tools, "rules/" + number.name);
        if (changed) actions.push_back(RulesAction{SetNumber{number.name, static_cast<double>(value), true}});
        if (ImGui::IsItemDeactivatedAfterEdit()) actions.push_back(RulesAction{CommitPreview{}});
    }
    return actions;
}

}  // namespace rinceau
