// Windows that ask about files, and the export that runs.

#include <imgui.h>

#include <algorithm>

#include "editor/model/file_kind.h"
#include "editor/panels/file_browser.h"
#include "editor/panels/modal_window.h"
#include "editor/panels/panel.h"
#include "editor/panels/pick_list_window.h"
#include "editor/panels/recovery_window.h"

namespace rinceau {
namespace {

constexpr float question_width = 460;  ///< at scale 1

struct AnswerButton {
    const char* label;
    const char* name;
    FileAnswer answer;
};

/// What a question looks like.
struct QuestionText {
    std::string title;
    std::string text;
    std::vector<AnswerButton> buttons;  ///< the first one is also Enter's
};

QuestionText text_of(const UnsavedQuestion&, const EditorState& state) {
    const std::string name = state.file.path.empty() ? "This document" : file_name_of(state.file.path);
    return {"Unsaved changes",
            name + " has changes that are not saved.",
            {{"Save", "ask/Save", FileAnswer::save},
             {"Discard", "ask/Discard", FileAnswer::discard},
             {"Cancel", "ask/Cancel", FileAnswer::cancel}}};
}

QuestionText text_of(const ReplaceQuestion& question, const EditorState&) {
    std::string names;
    for (const std::string& name : question.names) names += (names.empty() ? "" : "\n") + name;
    return {"Replace",
            names + (question.names.size() > 1 ? "\nare there already." : "\nis there already."),
            {{"Replace", "ask/Replace", FileAnswer::replace}, {"Cancel", "ask/Cancel", FileAnswer::cancel}}};
}

QuestionText text_of(const ChangedQuestion& question, const EditorState&) {
    return {
        "Changed by another program",
        question.path + "\nis not as it was when it was opened here: another program, or another window, has written it.",
        {{"Save as...", "ask/SaveAs", FileAnswer::save_as},
         {"Overwrite", "ask/Overwrite", FileAnswer::replace},
         {"Cancel", "ask/Cancel", FileAnswer::cancel}}};
}

bool key(ImGuiKey_ which) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(which), false); }

Actions question_window(const EditorState& state, const PanelTools& tools) {
    QuestionText question;
    if (state.file.question)
        question = std::visit([&](const auto& known) { return text_of(known, state); }, *state.file.question);
    ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Always, {0.5F, 0.5F});
    const std::string title = question.title + "###file question";
    if (!begin_modal(title.c_str(), state.file.question.has_value(), ImGuiWindowFlags_AlwaysAutoResize)) return {};
    Actions actions;
    const auto answer = [&](FileAnswer chosen) { actions.push_back(FileAction{AnswerFileQuestion{chosen}}); };
    ImGui::PushTextWrapPos(question_width * tools.scale);
    ImGui::TextUnformatted(question.text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::Spacing();
    for (const AnswerButton& button : question.buttons) {
        if (ImGui::Button(button.label)) answer(button.answer);
        note_place(tools, button.name);
        ImGui::SameLine();
    }
    const bool first_frames = ImGui::IsWindowAppearing();  // the key that led here is still down
    if (actions.empty() && !first_frames && key(ImGuiKey_Enter)) answer(question.buttons.front().answer);
    if (actions.empty() && key(ImGuiKey_Escape)) answer(FileAnswer::cancel);
    ImGui::EndPopup();
    return actions;
}

Actions export_window(const EditorState& state, const PanelTools& tools) {
    Actions actions;
    if (!state.file.exporting || state.file.question) return actions;
    const ImGuiViewport* viewport = ImGui::GetMainViewport();
    ImGui::SetNextWindowPos({viewport->WorkPos.x + viewport->WorkSize.x / 2, viewport->WorkPos.y + viewport->WorkSize.y},
                            ImGuiCond_Always, {0.5F, 1});
    constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                                       ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing;
    ImGui::Begin("Exporting", nullptr, flags);
    ImGui::Text("%s: %s", file_name_of(state.file.exporting->path).c_str(), state.file.exporting->stage.c_str());
    ImGui::SameLine();
    ImGui::ProgressBar(static_cast<float>(state.file.exporting->fraction), {question_width * tools.scale / 3, 0});
    ImGui::SameLine();
    if (ImGui::Button("Stop")) actions.push_back(FileAction{CancelExport{}});
    note_place(tools, "export/Stop");
    ImGui::End();
    return actions;
}

}  // namespace

Actions file_dialogs(const EditorState& state, const PanelTools& tools) {
    Actions actions;
    for (const auto window : {recovery_window, pick_list_window, file_browser, question_window, export_window})
        for (Action& action : window(state, tools)) actions.push_back(std::move(action));
    return actions;
}

}  // namespace rinceau
