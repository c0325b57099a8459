// All rules as cards.

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cctype>

#include "editor/panels/number_field.h"
#include "editor/panels/rules_panel_parts.h"
#include "geometry/index.h"

namespace rinceau {
namespace {

bool fits(const std::string& filter, const std::string& text) {
    const auto same = [](char a, char b) {
        return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
    };
    return std::search(text.begin(), text.end(), filter.begin(), filter.end(), same) != text.end();
}

void draw_filter(const EditorState& state, const PanelTools& tools, Actions& actions) {
    constexpr float room_for_all = 5;  // in heights of a letter
    std::string filter = state.rules.filter;
    bool details = state.rules.details;
    ImGui::SetNextItemWidth(-room_for_all * ImGui::GetFontSize());
    if (ImGui::InputTextWithHint("##filter", "Find a rule or number", &filter))
        actions.push_back(RulesAction{FilterRules{filter}});
    note_place(tools, "rules/Filter");
    ImGui::SameLine();
    if (ImGui::Checkbox("All", &details)) actions.push_back(RulesAction{ShowRuleDetails{details}});
    note_place(tools, "rules/All");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Details, too: conditions, opacities, the canvas");
}

void draw_section(const EditorState& state, const PanelTools& tools, const char* title, const std::vector<int>& numbers,
                  ImGuiTreeNodeFlags flags, Actions& actions) {
    const std::vector<int> some = shown_numbers(state, numbers);
    if (some.empty()) return;
    const bool open = ImGui::CollapsingHeader(title, flags);
    note_place(tools, std::string("rules/") + title);
    if (open) draw_numbers(state, tools, some, nullptr, actions);
}

void draw_folded(const EditorState& state, const PanelTools& tools, const char* title, const std::vector<RuleCard>& cards,
                 Actions& actions) {
    if (cards.empty()) return;
    const std::string label = std::string(title) + " (" + std::to_string(cards.size()) + ")###" + title;
    const bool open = ImGui::CollapsingHeader(label.c_str());
    note_place(tools, std::string("rules/") + title);
    if (!open) return;
    ImGui::Indent();
    for (const RuleCard& card : cards)
        if (is_shown(state, card)) draw_card(state, tools, card, false, actions);
    ImGui::Unindent();
}

void draw_add(const EditorState& state, const PanelTools& tools, Actions& actions) {
    if (ImGui::Button("Add a rule ..", {-1, 0})) ImGui::OpenPopup("add");
    note_place(tools, "rules/add");
    if (!ImGui::BeginPopup("add")) return;
    const std::string symbol = selected_symbol(state);
    ImGui::TextDisabled("of %s", symbol.empty() ? "the first drawing" : symbol.c_str());
    const auto entry = [&](const char* name, const char* label, ProductionShape shape) {
        const bool chosen = ImGui::MenuItem(label);
        note_place(tools, std::string("rules/add ") + name);
        if (!chosen) return;
        AddProductionOptions options{.shape = shape};
        if (!symbol.empty()) options.elements = {symbol};
        actions.push_back(RulesAction{AddProduction{options}});
    };
    entry("sequence", "Row", ProductionShape::sequence);
    entry("ring", "Ring", ProductionShape::ring);
    entry("branching", "Tree", ProductionShape::branching);
    entry("group", "Group", ProductionShape::group);
    entry("empty", "Empty rule", ProductionShape::empty);
    ImGui::EndPopup();
}

void draw_removal(const EditorState& state, const PanelTools& tools, Actions& actions) {
    constexpr const char* title = "Remove the rule?";
    const auto& removal = state.rules.removal;
    if (removal && !ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
    if (!ImGui::BeginPopupModal(title, nullptr, ImGuiWindowFlags_AlwaysAutoResize)) return;
    if (!removal) {
        ImGui::CloseCurrentPopup();
        ImGui::EndPopup();
        return;
    }
    constexpr float widest = 26;  // in heights of a letter
    ImGui::PushTextWrapPos(widest * ImGui::GetFontSize());
    ImGui::TextUnformatted((removal->reason + ". Remove its uses, too? What follows them stays where it is.").c_str());
    ImGui::PopTextWrapPos();
    if (ImGui::Button("Remove all")) actions.push_back(RulesAction{RemoveProduction{removal->production, true}});
    note_place(tools, "rules/Remove all");
    ImGui::SameLine();
    if (ImGui::Button("Keep") || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape)))
        actions.push_back(RulesAction{KeepProduction{}});
    note_place(tools, "rules/Keep");
    ImGui::EndPopup();
}

void draw_step(const PanelTools& tools, const std::string& label, int steps, bool undone, Actions& actions) {
    ImGui::PushID(steps);
    if (undone) ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    if (ImGui::Selectable(label.c_str(), steps == 0)) actions.push_back(RulesAction{GoInHistory{steps}});
    if (undone) ImGui::PopStyleColor();
    note_place(tools, "rules/step " + std::to_string(steps));
    ImGui::PopID();
}

/// Every step is clicked to go there; what was undone is grey.
void draw_history(const EditorState& state, const PanelTools& tools, Actions& actions) {
    const History& history = state.history;
    const bool open = ImGui::CollapsingHeader("History");
    note_place(tools, "rules/History");
    if (!open) return;
    const int past = static_cast<int>(history.past.size());
    const int all = past + static_cast<int>(history.future.size()) + 1;
    ImGuiListClipper clipper;
    clipper.Begin(all);
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const int steps = i - past;
            const std::string label = i == 0       ? std::string("as it was opened")
                                      : steps <= 0 ? history.past[at(i - 1)].label
                                                   : history.future[history.future.size() - at(steps)].label;
            draw_step(tools, label, steps, steps > 0, actions);
        }
    }
}

/// Marks the card of what is selected, and brings it to be seen when the selection changes.
class SelectedCard {
  public:
    explicit SelectedCard(const EditorState& state) {
        selected_ = selected_rule(state);
        int* const last = ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("selected rule"), no_rule);
        comes_ = *last != selected_ && selected_ != no_rule;
        *last = selected_;
    }
    static int rule_of(const RuleCard& card) { return card.kind == RuleCard::Kind::axiom ? -1 : card.index; }

    void begin(const RuleCard& card) {
        is_it_ = rule_of(card) == selected_;
        if (!is_it_) return;
        ImGui::PushStyleColor(ImGuiCol_Header, ImGui::GetStyleColorVec4(ImGuiCol_HeaderActive));
        if (!comes_) return;
        ImGui::SetNextItemOpen(true);
        ImGui::SetScrollHereY(0);
    }
    void end() const {
        if (is_it_) ImGui::PopStyleColor();
    }

  private:
    static constexpr int no_rule = -2;
    int selected_ = no_rule;
    bool comes_ = false;
    bool is_it_ = false;
};

void draw_cards(const EditorState& state, const PanelTools& tools, Actions& actions) {
    constexpr std::size_t most_open = 30;
    const RuleSheet& sheet = *state.rules.sheet;
    const bool open = sheet.rules.size() <= most_open;
    SelectedCard selected(state);
    int hovered = no_production;
    for (const RuleCard& card : sheet.rules) {
        if (!is_shown(state, card)) continue;
        selected.begin(card);
        if (draw_card(state, tools, card, open, actions).hovered) hovered = SelectedCard::rule_of(card);
        selected.end();
    }
    if (hovered != state.canvas.hovered_production) actions.push_back(CanvasAction{HoverRule{hovered}});
}

}  // namespace

bool is_shown(const EditorState& state, const GrammarNumber& number) {
    return (state.rules.details || is_listed(number)) && fits(state.rules.filter, number.name);
}

bool is_shown(const EditorState& state, const RuleCard& card) {
    if (state.rules.filter.empty() || fits(state.rules.filter, card.title)) return true;
    return std::ranges::any_of(card.numbers,
                               [&](int index) { return is_shown(state, state.rules.sheet->numbers[at(index)]); });
}

std::vector<int> shown_numbers(const EditorState& state, const std::vector<int>& numbers) {
    std::vector<int> result;
    for (const int index : numbers)
        if (is_shown(state, state.rules.sheet->numbers[at(index)])) result.push_back(index);
    return result;
}

void draw_numbers(const EditorState& state, const PanelTools& tools, const std::vector<int>& numbers, const RuleCard* card,
                  Actions& actions) {
    const RuleSheet& sheet = *state.rules.sheet;
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(numbers.size()), ImGui::GetFrameHeightWithSpacing());
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const GrammarNumber& number = sheet.numbers[at(numbers[at(i)])];
            const bool last = at(i) + 1 == numbers.size();
            const std::string label = card != nullptr ? name_on_card(*card, number.name) : number.name;
            number_field(state, tools, number, label, last ? "" : sheet.numbers[at(numbers[at(i + 1)])].name, actions);
        }
    }
}

void draw_rule_list(const EditorState& state, const PanelTools& tools, Actions& actions) {
    const RuleSheet& sheet = *state.rules.sheet;
    draw_derivation(state, tools, actions);
    draw_filter(state, tools, actions);
    draw_section(state, tools, "Counts", sheet.counts, ImGuiTreeNodeFlags_DefaultOpen, actions);
    draw_section(state, tools, "Constants", sheet.constants, ImGuiTreeNodeFlags_DefaultOpen, actions);
    draw_cards(state, tools, actions);
    draw_add(state, tools, actions);
    draw_folded(state, tools, "Exceptions", sheet.exceptions, actions);
    draw_folded(state, tools, "Styles", sheet.styles, actions);
    draw_section(state, tools, "Picture", sheet.picture, 0, actions);
    draw_history(state, tools, actions);
    draw_removal(state, tools, actions);
}

}  // namespace rinceau
