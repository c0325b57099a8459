// The terminals: what is drawn, how often, and in which paints.

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include "editor/model/tool_view.h"
#include "editor/panels/panel.h"

namespace rinceau {
namespace {

constexpr float thumbnail_ems = 2.5F;
constexpr double one = 1;
constexpr double nothing = 0;

Style style_of(const Grammar& grammar, int number) {
    const auto found = std::ranges::find(grammar.styles, number, &NumberedStyle::number);
    return found == grammar.styles.end() ? Style{} : found->style;
}

/// "12 times, 3 mirrored, 4-fold symmetry".
std::string facts(const EditorState& state, const Terminal& terminal, const TerminalUse& use) {
    std::string text = std::to_string(use.count) + (use.count == 1 ? " time" : " times");
    if (use.mirrored > 0) text += ", " + std::to_string(use.mirrored) + " mirrored";
    if (!state.document.report) return text;
    const auto& known = state.document.report->terminals;
    const auto report = std::ranges::find(known, terminal.symbol, &TerminalReport::symbol);
    if (report == known.end()) return text;
    if (report->symmetry == 0) text += ", round";
    if (report->symmetry > 1) text += ", " + std::to_string(report->symmetry) + "-fold symmetry";
    return text;
}

void thumbnail(const PanelTools& tools, int look) {
    if (!tools.thumbnail) return;
    const float size = thumbnail_ems * ImGui::GetFontSize();
    const unsigned texture = look < 0 ? 0 : tools.thumbnail(look);
    if (texture == 0) {
        ImGui::Dummy({size, size});
    } else {
        ImGui::Image(reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(texture)), {size, size}, {0, 1}, {1, 0});
    }
    ImGui::SameLine();
}

/// What a field of a paint did.
struct FieldUse {
    bool changed = false;
    bool let_go = false;
};

/// Notes the last widget and what was done with it.
void look_at_field(const PanelTools& tools, const std::string& name, bool changed, FieldUse& use) {
    note_place(tools, name);
    use.changed = use.changed || changed;
    use.let_go = use.let_go || ImGui::IsItemDeactivatedAfterEdit();
}

void paint_field(const PanelTools& tools, const std::string& terminal, const char* label, Paint& paint, FieldUse& use) {
    constexpr float most = 255;
    const std::string name = "terminals/" + terminal + ' ' + label;
    ImGui::PushID(label);
    bool painted = !std::holds_alternative<NoPaint>(paint);
    const bool switched = ImGui::Checkbox("##painted", &painted);
    note_place(tools, name + " on");
    if (switched) paint = painted ? Paint{Color{}} : Paint{NoPaint{}};
    use.changed = use.changed || switched;
    use.let_go = use.let_go || switched;
    ImGui::SameLine();
    if (const auto* color = std::get_if<Color>(&paint)) {
        std::array<float, 3> shown{static_cast<float>(color->red) / most, static_cast<float>(color->green) / most,
                                   static_cast<float>(color->blue) / most};
        const bool changed = ImGui::ColorEdit3(label, shown.data(), ImGuiColorEditFlags_DisplayHex);
        look_at_field(tools, name, changed, use);
        const auto channel = [](float value) { return static_cast<std::uint8_t>(std::lround(value * most)); };
        if (changed) paint = Color{channel(shown[0]), channel(shown[1]), channel(shown[2])};
    } else {
        ImGui::TextDisabled(painted ? "%s: a gradient" : "%s: none", label);
        note_place(tools, name);
    }
    ImGui::PopID();
}

void number_field(const PanelTools& tools, const std::string& terminal, const char* label, double& value, const double* most,
                  FieldUse& use) {
    constexpr float step = 0.01F;
    const bool changed =
        ImGui::DragScalar(label, ImGuiDataType_Double, &value, step, &nothing, most, "%.4g", ImGuiSliderFlags_AlwaysClamp);
    look_at_field(tools, "terminals/" + terminal + ' ' + label, changed, use);
}

void dash_field(const PanelTools& tools, const std::string& terminal, Stroke& stroke, FieldUse& use) {
    if (stroke.dashes.size() > 2) return ImGui::TextDisabled("dashes: %d lengths", static_cast<int>(stroke.dashes.size()));
    std::array<double, 2> dash{0, 0};
    std::ranges::copy(stroke.dashes, dash.begin());
    constexpr float step = 0.05F;
    const bool changed =
        ImGui::DragScalarN("dash, gap", ImGuiDataType_Double, dash.data(), 2, step, &nothing, nullptr, "%.4g");
    look_at_field(tools, "terminals/" + terminal + " dash", changed, use);
    if (!changed) return;
    stroke.dashes.clear();
    if (dash[0] > 0) stroke.dashes = {dash[0], dash[1] > 0 ? dash[1] : dash[0]};
}

FieldUse style_fields(const PanelTools& tools, const std::string& terminal, Style& style) {
    FieldUse use;
    paint_field(tools, terminal, "fill", style.fill, use);
    bool holes = style.fill_rule == FillRule::evenodd;
    const bool switched = ImGui::Checkbox("even-odd holes", &holes);
    look_at_field(tools, "terminals/" + terminal + " fill rule", switched, use);
    use.let_go = use.let_go || switched;
    if (switched) style.fill_rule = holes ? FillRule::evenodd : FillRule::nonzero;
    paint_field(tools, terminal, "stroke", style.stroke.paint, use);
    number_field(tools, terminal, "stroke width", style.stroke.width, nullptr, use);
    dash_field(tools, terminal, style.stroke, use);
    number_field(tools, terminal, "opacity", style.opacity, &one, use);
    return use;
}

bool is_restyled(const EditorState& state, const std::string& symbol) {
    if (!shows_tool_preview(state)) return false;
    const auto* edit = std::get_if<RestyleEdit>(state.tools.edit.get());
    return edit != nullptr && edit->symbol == symbol;
}

void restyle_fields(const EditorState& state, const PanelTools& tools, const Terminal& terminal, Actions& actions) {
    const std::vector<std::string> sharing = sharing_style(*state.document.grammar, terminal.symbol);
    if (sharing.empty()) return ImGui::TextDisabled("Its paints are set where it comes from");
    ToolSettings settings = state.tools.settings;
    if (sharing.size() > 1) {
        const std::string label = "also the " + std::to_string(sharing.size() - 1) + " that share its style";
        if (ImGui::Checkbox(label.c_str(), &settings.terminals.shared)) actions.push_back(ToolsAction{SetTools{settings}});
        note_place(tools, "terminals/" + terminal.symbol + " shared");
    }
    RestyleEdit edit{terminal.symbol, style_of(*shown_document(state).resolved, terminal.style),
                     settings.terminals.shared ? RestyleWhat::all_that_share : RestyleWhat::only_this};
    const FieldUse use = style_fields(tools, terminal.symbol, edit.style);
    if (use.let_go) {
        actions.push_back(ToolsAction{UseTool{shared_edit(edit)}});
    } else if (use.changed) {
        actions.push_back(ToolsAction{UseTool{shared_edit(edit), true}});
    }
    if (!is_restyled(state, terminal.symbol)) return;
    if (ImGui::Button("Keep")) actions.push_back(ToolsAction{KeepTool{}});
    note_place(tools, "terminals/" + terminal.symbol + " keep");
}

void opened_terminal(const EditorState& state, const PanelTools& tools, const Terminal& terminal, Actions& actions) {
    ImGui::Indent();
    constexpr float label_ems = 7;
    ImGui::PushItemWidth(-label_ems * ImGui::GetFontSize());
    if (ImGui::Button("Replace, redraw..")) {
        ToolSettings settings = state.tools.settings;
        settings.replace.symbol = terminal.symbol;
        settings.replace.only_selected = false;
        actions.push_back(ToolsAction{SetTools{settings}});
        actions.push_back(ToolsAction{OpenTool{ToolSection::replace}});
    }
    note_place(tools, "terminals/" + terminal.symbol + " replace");
    restyle_fields(state, tools, terminal, actions);
    ImGui::PopItemWidth();
    ImGui::Unindent();
}

}  // namespace

Actions terminals_panel(const EditorState& state, const PanelTools& tools) {
    Actions actions;
    const std::vector<Terminal>& terminals = shown_document(state).resolved->terminals;
    const std::vector<TerminalUse> uses = terminal_uses(state);
    int hovered = -1;
    for (std::size_t i = 0; i < terminals.size(); ++i) {
        const Terminal& terminal = terminals[i];
        ImGui::PushID(terminal.symbol.c_str());
        thumbnail(tools, uses[i].look);
        const bool opened = state.tools.settings.terminals.opened == terminal.symbol;
        if (ImGui::Selectable((terminal.symbol + "  " + facts(state, terminal, uses[i])).c_str(), opened)) {
            ToolSettings settings = state.tools.settings;
            settings.terminals.opened = opened ? std::string() : terminal.symbol;
            actions.push_back(ToolsAction{SetTools{settings}});
        }
        note_place(tools, "terminals/" + terminal.symbol);
        if (ImGui::IsItemHovered()) hovered = static_cast<int>(i);
        if (opened) opened_terminal(state, tools, terminal, actions);
        ImGui::PopID();
    }
    if (hovered != state.canvas.hovered_terminal) actions.push_back(CanvasAction{HoverTerminal{hovered}});
    return actions;
}

}  // namespace rinceau
