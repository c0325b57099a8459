// Rules in another form: rings and rows, groups, rules put in the place of their symbols.

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "editor/panels/tools_panel.h"

namespace rinceau {
namespace {

constexpr double nothing = 0;

/// The symbol that is set, or the first one.
const std::string& chosen(const std::vector<std::string>& symbols, const std::string& set) {
    return std::ranges::count(symbols, set) > 0 ? set : symbols.front();
}

bool symbol_choice(const PanelTools& tools, const char* name, const std::vector<std::string>& symbols, std::string& symbol) {
    bool changed = false;
    const bool open = ImGui::BeginCombo("rule", symbol.c_str());
    note_place(tools, name);
    if (!open) return false;
    for (const std::string& known : symbols) {
        if (ImGui::Selectable(known.c_str(), known == symbol)) {
            symbol = known;
            changed = true;
        }
        note_place(tools, std::string(name) + "/" + known);
    }
    ImGui::EndCombo();
    return changed;
}

bool length_field(const PanelTools& tools, const char* label, const char* name, double& length) {
    constexpr float units_a_pixel = 0.5F;
    const char* format = length == 0 ? "as it is" : "%.4g";
    const bool changed = ImGui::DragScalar(label, ImGuiDataType_Double, &length, units_a_pixel, &nothing, nullptr, format);
    note_place(tools, name);
    return changed;
}

void tool_button(const PanelTools& tools, const char* label, const ToolEdit& edit, Actions& actions) {
    if (ImGui::Button(label)) actions.push_back(ToolsAction{UseTool{shared_edit(edit)}});
    note_place(tools, std::string("tools/") + label);
}

std::string string_label(const Grammar& grammar, const StringPlace& place) {
    const auto index = static_cast<std::size_t>(place.index);
    if (place.in == StringPlace::In::axiom || index >= grammar.productions.size()) return "axiom";
    return grammar.productions[index].symbol;
}

bool string_choice(const PanelTools& tools, const Grammar& grammar, StringPlace& place) {
    bool changed = false;
    const bool open = ImGui::BeginCombo("in", string_label(grammar, place).c_str());
    note_place(tools, "tools/Group in");
    if (!open) return false;
    for (const StringPlace& known : strings_of(grammar)) {
        if (known.in == StringPlace::In::exception) continue;
        ImGui::PushID(known.in == StringPlace::In::axiom ? -1 : known.index);
        if (ImGui::Selectable(string_label(grammar, known).c_str(), known == place)) {
            place = known;
            changed = true;
        }
        note_place(tools, "tools/Group in/" + string_label(grammar, known));
        ImGui::PopID();
    }
    ImGui::EndCombo();
    return changed;
}

/// The modules in words, as far as there is room.
std::string modules_text(const std::vector<ModuleTemplate>& string, int first, int last) {
    constexpr std::size_t room = 400;
    std::string text;
    for (int i = first; i <= last && text.size() < room; ++i) {
        const ModuleTemplate& module = string[static_cast<std::size_t>(i)];
        text += (text.empty() ? "" : " ") + module.symbol;
        for (std::size_t k = 0; k < module.arguments.size(); ++k)
            text += (k == 0 ? "(" : ", ") + to_text(module.arguments[k]);
        if (!module.arguments.empty()) text += ")";
    }
    return text.size() < room ? text : text + " ..";
}

}  // namespace

void ring_section(const EditorState& state, const PanelTools& tools, Actions& actions) {
    if (!tool_header(state, tools, ToolSection::ring, "Ring and row", actions)) return;
    const std::vector<std::string> symbols = symbols_of_rows(*state.document.grammar);
    if (symbols.empty()) return ImGui::TextDisabled("No rule repeats itself");
    ToolSettings settings = state.tools.settings;
    RingSettings& ring = settings.ring;
    ring.symbol = chosen(symbols, ring.symbol);
    bool changed = symbol_choice(tools, "tools/Ring rule", symbols, ring.symbol);
    const bool radius = length_field(tools, "radius", "tools/Ring radius", ring.radius);
    tool_button(tools, "Make a ring", RingEdit{ring.symbol, {ring.radius}}, actions);
    const bool distance = length_field(tools, "distance", "tools/Row distance", ring.distance);
    tool_button(tools, "Make a row", RowEdit{ring.symbol, {ring.distance}}, actions);
    if (changed || radius || distance) actions.push_back(ToolsAction{SetTools{settings}});
    if (radius) actions.push_back(ToolsAction{UseTool{shared_edit(RingEdit{ring.symbol, {ring.radius}}), true}});
    if (distance) actions.push_back(ToolsAction{UseTool{shared_edit(RowEdit{ring.symbol, {ring.distance}}), true}});
}

void group_section(const EditorState& state, const PanelTools& tools, Actions& actions) {
    if (!tool_header(state, tools, ToolSection::group, "Group", actions)) return;
    const Grammar& grammar = *state.document.grammar;
    ToolSettings settings = state.tools.settings;
    GroupOptions& group = settings.group;
    if (static_cast<std::size_t>(group.string.index) >= std::max<std::size_t>(1, grammar.productions.size()))
        group.string = {};
    bool changed = string_choice(tools, grammar, group.string);
    const std::vector<ModuleTemplate>& string = string_at(grammar, group.string);
    if (string.empty()) return ImGui::TextDisabled("Nothing stands there");
    const int last = static_cast<int>(string.size()) - 1;
    group.first = std::clamp(group.first, 0, last);
    group.last = std::clamp(group.last, group.first, last);
    changed = ImGui::SliderInt("from", &group.first, 0, last) || changed;
    note_place(tools, "tools/Group from");
    changed = ImGui::SliderInt("to", &group.last, 0, last) || changed;
    note_place(tools, "tools/Group to");
    ImGui::TextWrapped("%s", modules_text(string, group.first, group.last).c_str());
    changed = ImGui::InputText("name", &group.name) || changed;
    note_place(tools, "tools/Group name");
    if (changed) actions.push_back(ToolsAction{SetTools{settings}});
    tool_button(tools, "Group modules", GroupEdit{group}, actions);
}

void inline_section(const EditorState& state, const PanelTools& tools, Actions& actions) {
    if (!tool_header(state, tools, ToolSection::inline_rule, "Inline", actions)) return;
    const std::vector<std::string> symbols = symbols_to_inline(*state.document.grammar);
    if (symbols.empty()) return ImGui::TextDisabled("No rule always applies without repeating itself");
    ToolSettings settings = state.tools.settings;
    settings.inlined = chosen(symbols, settings.inlined);
    if (symbol_choice(tools, "tools/Inline rule", symbols, settings.inlined))
        actions.push_back(ToolsAction{SetTools{settings}});
    tool_button(tools, "Inline the rule", InlineEdit{settings.inlined}, actions);
}

}  // namespace rinceau
