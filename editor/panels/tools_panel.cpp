// The tools that change the whole grammar: each shows what it would do and is kept by its button.

#include "editor/panels/tools_panel.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include "editor/model/tool_view.h"

namespace rinceau {

bool tool_header(const EditorState& state, const PanelTools& tools, ToolSection section, const char* label,
                 Actions& actions) {
    const bool wanted = state.tools.open == section;
    if (wanted) {
        ImGui::SetNextItemOpen(true);
        actions.push_back(ToolsAction{OpenTool{ToolSection::none}});
    }
    const bool usual = section <= ToolSection::replace;
    const std::string title = std::string(label) + "##section";  // a button of the same name stands below
    const bool open = ImGui::CollapsingHeader(title.c_str(), usual ? ImGuiTreeNodeFlags_DefaultOpen : ImGuiTreeNodeFlags_None);
    note_place(tools, std::string("tools/") + label + " section");
    if (wanted) {
        ImGui::SetScrollHereY(0);
        ImGui::SetKeyboardFocusHere();
    }
    return open;
}

namespace {

void previewed_tool(const EditorState& state, const PanelTools& tools, Actions& actions) {
    ImGui::TextWrapped("Preview: %s. Keep it, or press Esc.", state.preview_label.c_str());
    if (ImGui::Button("Keep")) actions.push_back(ToolsAction{KeepTool{}});
    note_place(tools, "tools/Keep");
    ImGui::SameLine();
    if (ImGui::Button("Drop")) actions.push_back(RulesAction{DropPreview{}});
    note_place(tools, "tools/Drop");
    for (const std::string& change : state.tools.changes) ImGui::TextWrapped("%s", change.c_str());
    if (state.tools.changes.empty()) ImGui::TextDisabled("Nothing is different");
}

/// Of one height, with a preview or without: what is dragged below stays where it is.
void preview_strip(const EditorState& state, const PanelTools& tools, Actions& actions) {
    constexpr float lines = 4.5F;
    if (ImGui::BeginChild("preview", {0, lines * ImGui::GetTextLineHeightWithSpacing()})) {
        if (!state.tools.mistake.empty()) ImGui::TextWrapped("%s", state.tools.mistake.c_str());
        if (state.tools.running)
            ImGui::TextDisabled("%s is being worked out ..", tool_label(*state.tools.running->edit).c_str());
        if (shows_tool_preview(state)) {
            previewed_tool(state, tools, actions);
        } else if (state.tools.mistake.empty() && !state.tools.running) {
            ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
            ImGui::TextWrapped("What you set here is shown at once as a preview; the tool's button makes it an edit.");
            ImGui::PopStyleColor();
        }
    }
    ImGui::EndChild();
}

void symmetrize_section(const EditorState& state, const PanelTools& tools, Actions& actions) {
    if (!tool_header(state, tools, ToolSection::symmetrize, "Symmetrize", actions)) return;
    ToolSettings settings = state.tools.settings;
    constexpr double least = 0;
    constexpr double most = 5;
    bool changed = ImGui::SliderScalar("tolerance", ImGuiDataType_Double, &settings.symmetrize.tolerance, &least, &most,
                                       "%.2f", ImGuiSliderFlags_AlwaysClamp);
    note_place(tools, "tools/Tolerance");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("How near is nearly regular: 1 = what a hand misses by");
    changed = ImGui::Checkbox("drop all exceptions", &settings.symmetrize.all_exceptions) || changed;
    note_place(tools, "tools/Drop all exceptions");
    if (changed) {
        actions.push_back(ToolsAction{SetTools{settings}});
        actions.push_back(ToolsAction{UseTool{shared_edit(SymmetrizeEdit{settings.symmetrize}), true}});
    }
    if (ImGui::Button("Symmetrize"))
        actions.push_back(ToolsAction{UseTool{shared_edit(SymmetrizeEdit{settings.symmetrize})}});
    note_place(tools, "tools/Symmetrize");
}

constexpr struct {
    const char* label;
    ReplaceFit fit;
} fits[] = {{"inside the old one's box", ReplaceFit::inside},
            {"covering it", ReplaceFit::cover},
            {"as wide", ReplaceFit::width},
            {"as high", ReplaceFit::height},
            {"as large as it is", ReplaceFit::none}};

bool fit_combo(const PanelTools& tools, ReplaceFit& fit) {
    bool changed = false;
    const char* shown = "";
    for (const auto& known : fits)
        if (known.fit == fit) shown = known.label;
    const bool open = ImGui::BeginCombo("fit", shown);
    note_place(tools, "tools/Fit");
    if (!open) return false;
    for (const auto& known : fits) {
        if (ImGui::Selectable(known.label, known.fit == fit)) {
            fit = known.fit;
            changed = true;
        }
    }
    ImGui::EndCombo();
    return changed;
}

bool symbol_combo(const EditorState& state, const PanelTools& tools, std::string& symbol) {
    bool changed = false;
    const bool open = ImGui::BeginCombo("symbol", symbol_to_replace(state).c_str());
    note_place(tools, "tools/Replace symbol");
    if (!open) return false;
    for (const std::string& known : symbols_of(*state.document.resolved)) {
        if (ImGui::Selectable(known.c_str(), known == symbol)) {
            symbol = known;
            changed = true;
        }
        note_place(tools, "tools/Replace symbol/" + known);
    }
    ImGui::EndCombo();
    return changed;
}

void replace_section(const EditorState& state, const PanelTools& tools, Actions& actions) {
    if (!tool_header(state, tools, ToolSection::replace, "Replace", actions)) return;
    ToolSettings settings = state.tools.settings;
    ReplaceSettings& replace = settings.replace;
    bool changed = symbol_combo(state, tools, replace.symbol);
    changed = ImGui::InputText("with", &replace.with) || changed;
    note_place(tools, "tools/Replace with");
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip(
            "Another symbol (Leaf, Ring(8)), a drawing (leaf.svg), a part of another grammar\n"
            "(vine.lsys#Leaf) or all of it (vine.lsys); nothing erases");
    ImGui::BeginDisabled(address_to_replace(state).empty() && !replace.only_selected);
    changed = ImGui::Checkbox("only the selected one", &replace.only_selected) || changed;
    note_place(tools, "tools/Only the selected one");
    ImGui::EndDisabled();
    bool moved = fit_combo(tools, replace.fit);
    constexpr float degrees_a_pixel = 1;
    moved = ImGui::DragScalar("turn", ImGuiDataType_Double, &replace.turn, degrees_a_pixel, nullptr, nullptr, "%.4g deg") ||
            moved;
    note_place(tools, "tools/Replace turn");
    moved = ImGui::Checkbox("in the style that is there", &replace.restyle) || moved;
    note_place(tools, "tools/Restyle");
    if (changed || moved) actions.push_back(ToolsAction{SetTools{settings}});
    const bool previews = ImGui::Button("Preview") || (moved && shows_tool_preview(state));
    if (previews) actions.push_back(ToolsAction{UseReplace{true}});
    note_place(tools, "tools/Replace preview");
    ImGui::SameLine();
    if (ImGui::Button("Replace")) actions.push_back(ToolsAction{UseReplace{}});
    note_place(tools, "tools/Replace");
}

}  // namespace

Actions tools_panel(const EditorState& state, const PanelTools& tools) {
    Actions actions;
    ImGui::PushItemWidth(-ImGui::GetFontSize() * label_ems);
    preview_strip(state, tools, actions);
    randomize_section(state, tools, actions);
    symmetrize_section(state, tools, actions);
    replace_section(state, tools, actions);
    ring_section(state, tools, actions);
    group_section(state, tools, actions);
    inline_section(state, tools, actions);
    ImGui::PopItemWidth();
    return actions;
}

}  // namespace rinceau
