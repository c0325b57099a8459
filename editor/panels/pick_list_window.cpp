// Samples and recent files to choose from.

#include "editor/panels/pick_list_window.h"

#include <imgui.h>

#include <algorithm>

#include "editor/model/file_kind.h"
#include "editor/panels/modal_window.h"

namespace rinceau {
namespace {

constexpr float wide = 480;  // at scale 1
constexpr float high = 440;
constexpr int rows_a_page = 12;

bool key(ImGuiKey_ which) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(which)); }

void items(const PickList& list, const PanelTools& tools, Actions& actions) {
    const bool samples = list.of == PickList::Of::samples;
    int number = 0;
    for (const PickItem& item : list.items) {
        const std::string label = item.label + "##" + std::to_string(number);
        if (ImGui::Selectable(label.c_str(), number == list.selected)) actions.push_back(DialogAction{PickItemAt{number}});
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", item.path.c_str());
        note_place(tools, (samples ? "samples/" + stem_of(item.path) : "recent/" + file_name_of(item.path)));
        if (number == list.selected && !ImGui::IsItemVisible()) ImGui::SetScrollHereY();
        ++number;
    }
    if (list.items.empty())
        ImGui::TextDisabled("%s", list.waiting ? "Looking..."
                                  : samples    ? "No samples are installed"
                                               : "No file was open yet");
}

}  // namespace

Actions pick_list_window(const EditorState& state, const PanelTools& tools) {
    const bool wanted = state.dialog.list && !state.file.question;
    const bool samples = state.dialog.list && state.dialog.list->of == PickList::Of::samples;
    const ImVec2 room = ImGui::GetMainViewport()->WorkSize;
    ImGui::SetNextWindowSize({std::min(wide * tools.scale, room.x), std::min(high * tools.scale, room.y)},
                             ImGuiCond_Appearing);
    ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Appearing, {0.5F, 0.5F});
    if (!begin_modal(samples ? "New from a sample###pick list" : "Recent files###pick list", wanted, ImGuiWindowFlags_None))
        return {};
    Actions actions;
    const auto act = [&](const DialogAction& action) { actions.push_back(action); };
    const bool appearing = ImGui::IsWindowAppearing();
    if (ImGui::BeginChild("items", {0, -ImGui::GetFrameHeightWithSpacing()}, true))
        items(*state.dialog.list, tools, actions);
    ImGui::EndChild();
    if (ImGui::Button("Open")) act(PickItemAt{});
    note_place(tools, samples ? "samples/OK" : "recent/OK");
    ImGui::SameLine();
    if (ImGui::Button("Cancel") || key(ImGuiKey_Escape)) act(ClosePickList{});
    note_place(tools, samples ? "samples/Cancel" : "recent/Cancel");
    if (key(ImGuiKey_DownArrow)) act(MoveInPickList{1});
    if (key(ImGuiKey_UpArrow)) act(MoveInPickList{-1});
    if (key(ImGuiKey_PageDown)) act(MoveInPickList{rows_a_page});
    if (key(ImGuiKey_PageUp)) act(MoveInPickList{-rows_a_page});
    if (!appearing && actions.empty() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter), false)) act(PickItemAt{});
    ImGui::EndPopup();
    return actions;
}

}  // namespace rinceau
