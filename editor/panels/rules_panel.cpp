// The rules: as cards, or as text.

#include <imgui.h>

#include "editor/panels/rules_panel_parts.h"

namespace rinceau {
namespace {

void draw_views(const EditorState& state, const PanelTools& tools, Actions& actions) {
    const auto view = [&](const char* label, const char* name, RulesView which) {
        if (ImGui::RadioButton(label, state.rules.view == which)) actions.push_back(RulesAction{ShowRules{which}});
        note_place(tools, std::string("rules/") + name);
    };
    view("Rules", "view rules", RulesView::rules);
    ImGui::SameLine();
    view(state.rules.text.changed ? "Text (not applied)" : "Text", "view text", RulesView::text);
}

}  // namespace

Actions rules_panel(const EditorState& state, const PanelTools& tools) {
    Actions actions;
    if (!state.rules.sheet) return actions;
    draw_views(state, tools, actions);
    if (state.rules.view == RulesView::text) {
        draw_rule_text(state, tools, actions);
    } else {
        draw_rule_list(state, tools, actions);
    }
    return actions;
}

}  // namespace rinceau
