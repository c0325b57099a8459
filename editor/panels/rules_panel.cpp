// The rules: the grammar as a person reads it, every number a drag field.

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "editor/panels/number_field.h"

namespace rinceau {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// Draws the sections of one frame.
class RulesView {
  public:
    RulesView(const EditorState& state, const PanelTools& tools, Actions& actions)
        : state_(state), tools_(tools), sheet_(*state.rules.sheet), actions_(actions) {}

    void draw() {
        draw_filter();
        draw_section("Counts", sheet_.counts, ImGuiTreeNodeFlags_DefaultOpen);
        draw_section("Constants", sheet_.constants, ImGuiTreeNodeFlags_DefaultOpen);
        constexpr std::size_t most_open = 30;
        const bool few = sheet_.rules.size() <= most_open;
        for (const RuleCard& card : sheet_.rules) draw_card(card, few ? ImGuiTreeNodeFlags_DefaultOpen : 0);
        draw_folded("Exceptions", sheet_.exceptions);
        draw_folded("Styles", sheet_.styles);
        draw_section("Picture", sheet_.picture, 0);
    }

  private:
    const EditorState& state_;
    const PanelTools& tools_;
    const RuleSheet& sheet_;
    Actions& actions_;

    bool fits(const std::string& text) const {
        const std::string& filter = state_.rules.filter;
        const auto same = [](char a, char b) {
            return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
        };
        return std::search(text.begin(), text.end(), filter.begin(), filter.end(), same) != text.end();
    }
    bool is_shown(const GrammarNumber& number) const {
        return (state_.rules.details || is_listed(number)) && fits(number.name);
    }
    std::vector<int> shown(const std::vector<int>& numbers) const {
        std::vector<int> result;
        for (const int index : numbers)
            if (is_shown(sheet_.numbers[at(index)])) result.push_back(index);
        return result;
    }

    void draw_filter() {
        std::string filter = state_.rules.filter;
        bool details = state_.rules.details;
        ImGui::SetNextItemWidth(-5 * ImGui::GetFontSize());
        if (ImGui::InputTextWithHint("##filter", "Find a rule or number", &filter))
            actions_.push_back(RulesAction{FilterRules{filter}});
        note_place(tools_, "rules/Filter");
        ImGui::SameLine();
        if (ImGui::Checkbox("All", &details)) actions_.push_back(RulesAction{ShowRuleDetails{details}});
        note_place(tools_, "rules/All");
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("Details, too: conditions, opacities, the canvas");
    }

    /// Only those that are seen are drawn.
    void draw_numbers(const std::vector<int>& numbers, const RuleCard* card) {
        ImGuiListClipper clipper;
        clipper.Begin(static_cast<int>(numbers.size()), ImGui::GetFrameHeightWithSpacing());
        while (clipper.Step()) {
            for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
                const GrammarNumber& number = sheet_.numbers[at(numbers[at(i)])];
                const bool last = at(i) + 1 == numbers.size();
                number_field(state_, tools_, number, card != nullptr ? name_on_card(*card, number.name) : number.name,
                             last ? "" : sheet_.numbers[at(numbers[at(i) + 1])].name, actions_);
            }
        }
    }

    void draw_section(const char* title, const std::vector<int>& numbers, ImGuiTreeNodeFlags flags) {
        const std::vector<int> some = shown(numbers);
        if (some.empty()) return;
        const bool open = ImGui::CollapsingHeader(title, flags);
        note_place(tools_, std::string("rules/") + title);
        if (open) draw_numbers(some, nullptr);
    }

    void draw_card(const RuleCard& card, ImGuiTreeNodeFlags flags) {
        const std::vector<int> numbers = shown(card.numbers);
        if (!state_.rules.filter.empty() && numbers.empty() && !fits(card.title)) return;
        const bool open = ImGui::CollapsingHeader((card.title + "##card").c_str(), flags);
        note_place(tools_, "rules/card " + card.title);
        if (!open) return;
        ImGui::PushID(card.title.c_str());
        ImGui::PushTextWrapPos(0);
        if (!card.comment.empty()) ImGui::TextDisabled("%s", card.comment.c_str());
        draw_text(card.text);
        ImGui::PopTextWrapPos();
        draw_numbers(numbers, &card);
        ImGui::PopID();
    }

    static void draw_text(const std::string& text) {
        constexpr std::size_t longest = 400;
        if (text.size() <= longest) {
            if (!text.empty()) ImGui::TextUnformatted(text.c_str());
            return;
        }
        if (ImGui::TreeNode("whole", "%s ..", text.substr(0, text.find(' ', longest / 4)).c_str())) {
            constexpr std::size_t most_shown = 20'000;
            ImGui::TextUnformatted(text.substr(0, most_shown).c_str());
            ImGui::TreePop();
        }
    }

    void draw_folded(const char* title, const std::vector<RuleCard>& cards) {
        if (cards.empty()) return;
        const std::string label = std::string(title) + " (" + std::to_string(cards.size()) + ")##" + title;
        const bool open = ImGui::CollapsingHeader(label.c_str());
        note_place(tools_, std::string("rules/") + title);
        if (!open) return;
        ImGui::Indent();
        for (const RuleCard& card : cards) draw_card(card, 0);
        ImGui::Unindent();
    }
};

}  // namespace

Actions rules_panel(const EditorState& state, const PanelTools& tools) {
    Actions actions;
    if (state.rules.sheet) RulesView(state, tools, actions).draw();
    return actions;
}

}  // namespace rinceau
