// One rule: its comment, its text, its numbers, and what can be done with it.

#include <imgui.h>
#include <imgui_stdlib.h>

#include "editor/panels/icon_button.h"
#include "editor/panels/rules_panel_parts.h"

namespace rinceau {
namespace {

/// Long statements are folded.
void draw_statement(const std::string& text) {
    constexpr std::size_t longest = 400;
    constexpr std::size_t beginning = 80;
    constexpr std::size_t most_shown = 20'000;
    if (text.empty()) return;
    if (text.size() <= longest) {
        ImGui::TextUnformatted(text.c_str());
        return;
    }
    const std::string label = text.substr(0, text.find(' ', beginning)) + " ..";
    if (!ImGui::TreeNode("whole", "%s", label.c_str())) return;
    ImGui::TextUnformatted(text.substr(0, most_shown).c_str());
    ImGui::TreePop();
}

class CardView {
  public:
    CardView(const EditorState& state, const PanelTools& tools, const RuleCard& card, Actions& actions)
        : state_(state), tools_(tools), card_(card), actions_(actions) {}

    void draw_body() {
        const std::vector<int> numbers = shown_numbers(state_, card_.numbers);
        draw_written();
        ImGui::PushTextWrapPos(0);
        if (!card_.comment.empty()) ImGui::TextDisabled("%s", card_.comment.c_str());
        draw_statement(card_.text);
        ImGui::PopTextWrapPos();
        draw_numbers(state_, tools_, numbers, &card_, actions_);
    }

    void draw_menu() {
        if (icon_button("##menu", Icon::menu, "Rename, comment, move, remove")) ImGui::OpenPopup("card menu");
        note("menu");
        if (!ImGui::BeginPopup("card menu")) return;
        const auto& productions = state_.document.grammar->productions;
        const Production& production = productions[static_cast<std::size_t>(card_.index)];
        if (entry("rename", "Rename ..", true)) act(WriteCard{CardField::name, card_.index, production.symbol});
        if (entry("comment", "Comment ..", true)) act(WriteCard{CardField::comment, card_.index, production.comment});
        if (entry("up", "Move up", card_.index > 0)) act(MoveProduction{card_.index, card_.index - 1});
        const bool last = static_cast<std::size_t>(card_.index) + 1 == productions.size();
        if (entry("down", "Move down", !last)) act(MoveProduction{card_.index, card_.index + 1});
        if (entry("remove", "Remove", true)) act(RemoveProduction{card_.index});
        ImGui::EndPopup();
    }

  private:
    const EditorState& state_;
    const PanelTools& tools_;
    const RuleCard& card_;
    Actions& actions_;

    void act(RulesAction action) { actions_.push_back(std::move(action)); }
    void note(const std::string& what) { note_place(tools_, "rules/" + what + ' ' + card_.title); }

    bool entry(const char* name, const char* label, bool enabled) {
        const bool chosen = ImGui::MenuItem(label, nullptr, false, enabled);
        note(name);
        return chosen;
    }

    /// The name or comment while it is written.
    void draw_written() {
        const auto& written = state_.rules.written;
        if (!written || card_.kind != RuleCard::Kind::production || written->production != card_.index) return;
        constexpr float comment_lines = 3.5F;
        std::string text = written->text;
        if (!ImGui::IsAnyItemActive()) ImGui::SetKeyboardFocusHere();
        ImGui::SetNextItemWidth(-1);
        bool entered = false;
        if (written->field == CardField::name) {
            entered = ImGui::InputTextWithHint("##written", "Name", &text, ImGuiInputTextFlags_EnterReturnsTrue);
        } else {
            const ImVec2 size{-1, comment_lines * ImGui::GetFontSize()};
            entered = ImGui::InputTextMultiline("##written", &text, size, ImGuiInputTextFlags_EnterReturnsTrue);
        }
        const bool dropped = ImGui::IsItemDeactivated() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
        const bool left = ImGui::IsItemDeactivated();
        note("written");
        if (text != written->text && !dropped) act(WriteCard{written->field, card_.index, text});
        if (entered) {
            act(EnterCard{});
        } else if (dropped) {
            act(StopCard{});
        } else if (left) {
            act(EnterCard{});
            act(StopCard{});
        }
        ImGui::TextDisabled(written->field == CardField::name ? "Enter renames it everywhere, Esc leaves it"
                                                              : "Ctrl+Enter sets the comment, Esc leaves it");
    }
};

}  // namespace

DrawnCard draw_card(const EditorState& state, const PanelTools& tools, const RuleCard& card, bool open, Actions& actions) {
    const bool has_menu = card.kind == RuleCard::Kind::production && !state.preview;
    ImGui::PushID(card.title.c_str());
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float right = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x - icon_button_width();
    const ImGuiTreeNodeFlags flags = open ? ImGuiTreeNodeFlags_DefaultOpen : 0;
    const bool is_open =
        ImGui::CollapsingHeader((card.title + "###header").c_str(), flags | ImGuiTreeNodeFlags_AllowItemOverlap);
    note_place(tools, "rules/card " + card.title);
    CardView view(state, tools, card, actions);
    if (has_menu) {
        ImGui::SameLine(right);
        view.draw_menu();
    }
    if (is_open) view.draw_body();
    ImGui::PopID();
    const ImVec2 high{low.x + ImGui::GetContentRegionAvail().x, ImGui::GetCursorScreenPos().y};
    return {.hovered = ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(low, high)};
}

}  // namespace rinceau
