#pragma once
// The parts of the panel of rules. Internal to the folder.

#include <string>
#include <vector>

#include "editor/panels/panel.h"

namespace rinceau {

/// Depth, seed and the counts.
void draw_derivation(const EditorState& state, const PanelTools& tools, Actions& actions);

/// One statement with its numbers. `hovered` = it, or something on it, is under the mouse.
struct DrawnCard {
    bool hovered = false;
};
DrawnCard draw_card(const EditorState& state, const PanelTools& tools, const RuleCard& card, bool open, Actions& actions);

/// Is it listed, as the filter says?
bool is_shown(const EditorState& state, const GrammarNumber& number);
bool is_shown(const EditorState& state, const RuleCard& card);

/// Those that are shown, in their order.
std::vector<int> shown_numbers(const EditorState& state, const std::vector<int>& numbers);

/// Only those that are seen are drawn. `card` = whose title need not be said again; null = of none.
void draw_numbers(const EditorState& state, const PanelTools& tools, const std::vector<int>& numbers, const RuleCard* card,
                  Actions& actions);

/// All rules as cards, with what stands above and below them.
void draw_rule_list(const EditorState& state, const PanelTools& tools, Actions& actions);

/// The whole text.
void draw_rule_text(const EditorState& state, const PanelTools& tools, Actions& actions);

}  // namespace rinceau
