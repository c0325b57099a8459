#include "editor/panels/number_field.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <cmath>

#include "editor/model/number_feel.h"
#include "editor/panels/icon_button.h"

namespace rinceau {
namespace {

constexpr float field_width = 7.5F;  // in heights of a letter

std::string text_to_type(const GrammarNumber& number) {
    if (!number.written.empty() && number.constant < 0) return number.written;
    return to_text(number_expression(number.value));
}

const GrammarNumber* number_before(const EditorState& state, const std::string& name) {
    const auto& origin = state.rules.origin;
    const int index = origin ? find_number(*origin, name) : -1;
    return index < 0 ? nullptr : &origin->numbers[static_cast<std::size_t>(index)];
}

void show_help(const EditorState& state, const GrammarNumber& number) {
    if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
    std::string text = number.name + "\n" + number.help;
    if (!number.unit.empty()) text += ", in " + number.unit;
    if (number.constant >= 0) {
        const auto& constants = state.rules.sheet->grammar->constants;
        text += "\nIt is the constant " + constants[static_cast<std::size_t>(number.constant)].name +
                ": what else is written with it changes, too.";
    } else if (!number.written.empty()) {
        text += "\nwritten " + number.written;
    }
    const char* const how = number.kind == NumberKind::count ? "\nSlide it, or Ctrl+click to type: 12, +=2, *=2"
                                                             : "\nDrag it, or double-click to type: 12, 80*1.5, +=2, 150%";
    text += state.document.locked.contains(number.name) ? "\nLocked: no edit changes it." : how;
    constexpr float tooltip_width = 22;  // in heights of a letter
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * tooltip_width);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

void typed_field(const EditorState& state, const GrammarNumber& number, const std::string& next, Actions& actions) {
    std::string text = state.rules.typed->text;
    if (!ImGui::IsAnyItemActive()) ImGui::SetKeyboardFocusHere();
    const bool entered = ImGui::InputText(("##typed " + number.name).c_str(), &text,
                                          ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    if (text != state.rules.typed->text) actions.push_back(RulesAction{TypeNumber{number.name, text}});
    const bool left = ImGui::IsItemDeactivated();
    if (entered) {
        actions.push_back(RulesAction{EnterTyped{}});
    } else if (left && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) {
        actions.push_back(RulesAction{StopTyping{}});
    } else if (left) {
        actions.push_back(RulesAction{EnterTyped{}});
        actions.push_back(RulesAction{StopTyping{}});
    } else if (ImGui::IsItemActive() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Tab))) {
        actions.push_back(RulesAction{EnterTyped{}});
        if (next.empty()) {
            actions.push_back(RulesAction{StopTyping{}});
        } else {
            actions.push_back(RulesAction{TypeNumber{next, {}}});
        }
    }
}

/// `%` is no format: the label is shown as it is.
std::string as_format(const std::string& label) {
    std::string format;
    for (const char c : label) format += c == '%' ? std::string("%%") : std::string(1, c);
    return format;
}

bool draw_value(const GrammarNumber& number, double start, double& value) {
    const NumberFeel feel = number_feel(number, start);
    const std::string id = "##" + number.name;
    const std::string format = as_format(number_label(number, number.value));
    constexpr ImGuiSliderFlags flags = ImGuiSliderFlags_NoInput | ImGuiSliderFlags_NoRoundToFormat;
    if (number.kind == NumberKind::count) {
        const double begin = std::min(std::max(feel.low, 0.0), number.value);  // a range without end has no slider
        const double end = std::max(slider_end(start), number.value);
        return ImGui::SliderScalar(id.c_str(), ImGuiDataType_Double, &value, &begin, &end, format.c_str(), flags);
    }
    return ImGui::DragScalar(id.c_str(), ImGuiDataType_Double, &value, static_cast<float>(feel.speed), &feel.low, &feel.high,
                             format.c_str(), flags);
}

void drag_field(const EditorState& state, const GrammarNumber& number, Actions& actions) {
    const auto& dragged = state.rules.dragged;
    const bool is_dragged = dragged && dragged->name == number.name;
    double value = is_dragged ? dragged->wanted : number.value;
    const bool changed = draw_value(number, is_dragged ? dragged->start : number.value, value);
    // the first click of two would have moved a slider
    const bool twice = number.kind != NumberKind::count && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
    const bool with_control = ImGui::GetIO().KeyCtrl && ImGui::IsMouseClicked(ImGuiMouseButton_Left);
    const bool types = ImGui::IsItemHovered() && (twice || with_control);
    const bool by_key = ImGui::IsItemFocused() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter));
    if (types || by_key) {
        actions.push_back(RulesAction{DropPreview{}});
        actions.push_back(RulesAction{TypeNumber{number.name, text_to_type(number)}});
    } else if (changed) {
        actions.push_back(RulesAction{SetNumber{number.name, value, true}});
    }
    if (is_dragged && ImGui::IsItemActive() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape)))
        actions.push_back(RulesAction{DropPreview{}});
    if (ImGui::IsItemDeactivated() && (is_dragged || changed)) actions.push_back(RulesAction{CommitPreview{}});
}

void draw_name(const EditorState& state, const GrammarNumber& number, const std::string& label, float width) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImGui::PushClipRect(low, {low.x + width, low.y + ImGui::GetFrameHeight()}, true);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(label.c_str());
    if (number.constant >= 0) {
        ImGui::SameLine(0, ImGui::GetFontSize() / 3);
        ImGui::TextDisabled("= %s",
                            state.rules.sheet->grammar->constants[static_cast<std::size_t>(number.constant)].name.c_str());
    }
    ImGui::PopClipRect();
    show_help(state, number);
}

void reset_button(const EditorState& state, const PanelTools& tools, const GrammarNumber& number, Actions& actions) {
    const GrammarNumber* before = number_before(state, number.name);
    constexpr double seen = 1e-9;
    const bool differs =
        before != nullptr && std::abs(before->value - number.value) > seen * std::max(1.0, std::abs(before->value));
    if (!differs || state.document.locked.contains(number.name)) {
        ImGui::Dummy({icon_button_width(), icon_button_width()});
        return;
    }
    const std::string help = "Back to " + number_label(*before, before->value) + ", as it was opened or analysed";
    if (icon_button("##reset", Icon::reset, help.c_str())) actions.push_back(RulesAction{ResetNumber{number.name}});
    note_place(tools, "rules/reset " + number.name);
}

void lock_button(const PanelTools& tools, const GrammarNumber& number, bool locked, Actions& actions) {
    const char* help = locked ? "Unlock: edits may change it again"
                              : "Lock: no edit, randomizing or symmetrizing changes it until it is unlocked";
    if (icon_button("##lock", locked ? Icon::locked : Icon::unlocked, help))
        actions.push_back(RulesAction{LockNumber{number.name, !locked}});
    note_place(tools, "rules/lock " + number.name);
}

}  // namespace

void number_field(const EditorState& state, const PanelTools& tools, const GrammarNumber& number, const std::string& label,
                  const std::string& next, Actions& actions) {
    ImGui::PushID(number.name.c_str());
    const bool locked = state.document.locked.contains(number.name);
    const float field = field_width * ImGui::GetFontSize();
    const float left = ImGui::GetCursorPosX();
    const float name_width =
        ImGui::GetContentRegionAvail().x - field - 2 * icon_button_width() - ImGui::GetStyle().ItemSpacing.x;
    draw_name(state, number, label, name_width);
    ImGui::SameLine(left + name_width + ImGui::GetStyle().ItemSpacing.x);
    ImGui::SetNextItemWidth(field);
    if (state.rules.typed && state.rules.typed->name == number.name) {
        typed_field(state, number, next, actions);
    } else {
        ImGui::BeginDisabled(locked);
        drag_field(state, number, actions);
        ImGui::EndDisabled();
        show_help(state, number);
    }
    note_place(tools, "rules/" + number.name);
    ImGui::SameLine(0, 0);
    reset_button(state, tools, number, actions);
    ImGui::SameLine(0, 0);
    lock_button(tools, number, locked, actions);
    ImGui::PopID();
}

}  // namespace rinceau
