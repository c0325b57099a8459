// The window as a whole: menus, toolbar, three columns, log and status line.

#include <imgui.h>
#include <imgui_internal.h>

#include <array>
#include <iterator>
#include <utility>

#include "editor/model/window_layout.h"
#include "editor/panels/command_menu.h"
#include "editor/panels/panel.h"

namespace rinceau {
namespace {

using DrawPanel = Actions (*)(const EditorState&, const PanelTools&);

constexpr float least_content = 230;  ///< width at scale 1 below which a panel is scrolled sideways

/// What a part of the window is drawn with, and what it adds to.
struct Drawing {
    const EditorState& state;
    const PanelTools& tools;
    Actions actions;
    ImVec2 spacing;  ///< of items within panels; between panels there is none

    void add(Actions more) {
        actions.insert(actions.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
    }
};

/// The keyboard goes where the state wants it, and the state is told where it went by itself.
void follow_focus(Drawing& drawing, EditorPanel panel) {
    const ShellState& shell = drawing.state.shell;
    if (shell.focus_wanted == panel) {
        ImGui::SetWindowFocus();
        ImGui::NavInitWindow(ImGui::GetCurrentWindow(), true);
        ImGui::GetCurrentContext()->NavDisableHighlight = false;
        drawing.actions.push_back(ShellAction{PanelFocused{panel}});
    } else if (shell.focused != panel && !shell.focus_wanted && ImGui::IsWindowFocused(ImGuiFocusedFlags_ChildWindows)) {
        drawing.actions.push_back(ShellAction{PanelFocused{panel}});
    }
}

void draw_panel(Drawing& drawing, EditorPanel panel, ImVec2 size, DrawPanel draw) {
    const float least = least_content * drawing.tools.scale;
    const bool narrow = size.x < least;
    if (narrow) ImGui::SetNextWindowContentSize({least, 0});
    if (ImGui::BeginChild(panel_title(panel), size, true, narrow ? ImGuiWindowFlags_HorizontalScrollbar : 0)) {
        follow_focus(drawing, panel);
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, drawing.spacing);
        drawing.add(draw(drawing.state, drawing.tools));
        ImGui::PopStyleVar();
    }
    ImGui::EndChild();
    note_place(drawing.tools, std::string("panel/") + panel_title(panel));
}

/// A bar between two parts; how far it was dragged, at scale 1.
float splitter(Drawing& drawing, const char* name, ImVec2 size, bool upright) {
    ImGui::PushItemFlag(ImGuiItemFlags_NoNav, true);
    ImGui::InvisibleButton(name, {std::max(1.0F, size.x), std::max(1.0F, size.y)});
    ImGui::PopItemFlag();
    note_place(drawing.tools, std::string("splitter/") + name);
    const bool active = ImGui::IsItemActive();
    if (active || ImGui::IsItemHovered()) {
        ImGui::SetMouseCursor(upright ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
        const ImU32 colour = ImGui::GetColorU32(active ? ImGuiCol_SeparatorActive : ImGuiCol_SeparatorHovered);
        ImGui::GetWindowDrawList()->AddRectFilled(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), colour);
    }
    const ImVec2 moved = ImGui::GetIO().MouseDelta;
    return active ? (upright ? moved.x : moved.y) / drawing.tools.scale : 0;
}

/// The heading of a part of the left column: a click folds and unfolds it.
void section_heading(Drawing& drawing, EditorPanel panel, bool open, float width) {
    const std::string title = panel_title(panel);
    ImGui::PushStyleVar(ImGuiStyleVar_ButtonTextAlign, {0, 0.5F});
    ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_WindowBg));
    const std::string label = (open ? "\u25be  " : "\u25b8  ") + title;
    if (ImGui::Button((label + "##" + title).c_str(), {width, 0}))
        drawing.actions.push_back(ShellAction{ShowPanel{panel, !open}});
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
    note_place(drawing.tools, "section/" + title);
}

void left_column(Drawing& drawing, const WindowLayout& layout) {
    const ShellState& shell = drawing.state.shell;
    ImGui::BeginGroup();
    section_heading(drawing, EditorPanel::terminals, shell.shown.terminals, layout.left);
    if (shell.shown.terminals) draw_panel(drawing, EditorPanel::terminals, {layout.left, layout.terminals}, terminals_panel);
    if (shell.shown.terminals && shell.shown.analysis) {
        const float moved = splitter(drawing, "terminals", {layout.left, layout.splitter}, false);
        const float both = (layout.terminals + layout.analysis) / drawing.tools.scale;
        PanelSizes sizes = shell.sizes;
        sizes.terminals_share += moved / std::max(1.0F, both);
        if (moved != 0) drawing.actions.push_back(ShellAction{ResizePanels{sizes}});
    }
    section_heading(drawing, EditorPanel::analysis, shell.shown.analysis, layout.left);
    if (shell.shown.analysis) draw_panel(drawing, EditorPanel::analysis, {layout.left, layout.analysis}, analysis_panel);
    ImGui::EndGroup();
}

void canvas_column(Drawing& drawing, const WindowLayout& layout) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse;
    const bool visible = ImGui::BeginChild("Canvas", {layout.canvas, layout.body}, false, flags);
    ImGui::PopStyleVar();
    if (visible) {
        follow_focus(drawing, EditorPanel::canvas);
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, drawing.spacing);
        drawing.add(canvas_panel(drawing.state, drawing.tools));
        drawing.add(welcome_panel(drawing.state, drawing.tools));
        ImGui::PopStyleVar();
    }
    ImGui::EndChild();
}

void tab(Drawing& drawing, EditorPanel panel, float width) {
    const bool chosen = drawing.state.shell.right_tab == panel;
    const std::string title = panel_title(panel);
    ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(chosen ? ImGuiCol_ChildBg : ImGuiCol_WindowBg));
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(chosen ? ImGuiCol_Text : ImGuiCol_TextDisabled));
    if (ImGui::Button((title + "##tab").c_str(), {width, 0})) drawing.actions.push_back(ShellAction{ShowPanel{panel, true}});
    ImGui::PopStyleColor(2);
    note_place(drawing.tools, "tab/" + title);
    if (!chosen) return;
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    const float line = std::max(1.0F, 2 * drawing.tools.scale);
    ImGui::GetWindowDrawList()->AddRectFilled({low.x, high.y - line}, high, ImGui::GetColorU32(ImGuiCol_CheckMark));
}

void right_column(Drawing& drawing, const WindowLayout& layout) {
    ImGui::BeginGroup();
    constexpr std::array<std::pair<EditorPanel, DrawPanel>, 3> panels{
        {{EditorPanel::rules, rules_panel}, {EditorPanel::tools, tools_panel}, {EditorPanel::growth, growth_panel}}};
    const float width = layout.right / static_cast<float>(panels.size());
    const float height = layout.body - ImGui::GetFrameHeight();
    for (const auto& [panel, draw] : panels) {
        tab(drawing, panel, width);
        if (panel != panels.back().first) ImGui::SameLine(0, 0);
    }
    for (const auto& [panel, draw] : panels)
        if (panel == drawing.state.shell.right_tab) draw_panel(drawing, panel, {layout.right, height}, draw);
    ImGui::EndGroup();
}

void columns(Drawing& drawing, const WindowLayout& layout) {
    const ShellState& shell = drawing.state.shell;
    PanelSizes sizes = shell.sizes;
    bool resized = false;
    const auto resize = [&](float& size, float shown, float moved) {
        if (moved == 0) return;
        size = shown / drawing.tools.scale + moved;
        resized = true;
    };
    if (shell.shown.left) {
        left_column(drawing, layout);
        ImGui::SameLine();
        resize(sizes.left, layout.left, splitter(drawing, "left", {layout.splitter, layout.body}, true));
        ImGui::SameLine();
    }
    canvas_column(drawing, layout);
    if (shell.shown.right) {
        ImGui::SameLine();
        resize(sizes.right, layout.right, -splitter(drawing, "right", {layout.splitter, layout.body}, true));
        ImGui::SameLine();
        right_column(drawing, layout);
    }
    if (shell.shown.log) {
        resize(sizes.log, layout.log, -splitter(drawing, "log", {ImGui::GetContentRegionAvail().x, layout.splitter}, false));
        draw_panel(drawing, EditorPanel::log, {0, layout.log}, log_panel);
    }
    if (resized) drawing.actions.push_back(ShellAction{ResizePanels{sizes}});
}

void body(Drawing& drawing) {
    const ImVec2 gaps = drawing.spacing;
    const ImVec2 free = ImGui::GetContentRegionAvail();
    const float status = ImGui::GetTextLineHeight() + gaps.y;
    const WindowLayout layout =
        window_layout(drawing.state.shell, {free.x, free.y - status, ImGui::GetFrameHeight(), drawing.tools.scale});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    columns(drawing, layout);
    ImGui::PopStyleVar();
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() + gaps.y);
    drawing.add(status_line(drawing.state, drawing.tools));
}

}  // namespace

Actions editor_window(const EditorState& state, const PanelTools& tools) {
    Drawing drawing{state, tools, {}, ImGui::GetStyle().ItemSpacing};
    const ImGuiViewport* viewport = ImGui::GetMainViewport();
    ImGui::SetNextWindowPos(viewport->WorkPos);
    ImGui::SetNextWindowSize(viewport->WorkSize);
    constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_MenuBar | ImGuiWindowFlags_NoMove |
                                       ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {6 * tools.scale, 4 * tools.scale});
    ImGui::Begin("Rinceau", nullptr, flags);
    ImGui::PopStyleVar(3);
    drawing.add(menu_bar(state, tools));
    drawing.add(toolbar(state, tools));
    body(drawing);
    ImGui::End();
    drawing.add(help_window(state, tools));
    drawing.add(command_palette(state, tools));
    drawing.add(file_dialogs(state, tools));
    return std::move(drawing.actions);
}

}  // namespace rinceau
