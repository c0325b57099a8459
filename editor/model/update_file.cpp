// Files: opening, and what asks before the document goes.

#include "editor/model/update_file_parts.h"

#include <filesystem>

#include "editor/model/new_document.h"
#include "editor/model/state_preferences.h"

namespace rinceau {

using Kind = FileIntent::Kind;

void ask_or_perform(Update& update, const FileIntent& intent) {
    if (has_unsaved_changes(update.state)) {
        update.state.file.question = UnsavedQuestion{intent};
    } else {
        perform_intent(update, intent);
    }
}

namespace {

/// What is open now is not the file's any more.
void begin_unnamed(Update& update, Document document) {
    FileState& file = update.state.file;
    file.path.clear();
    file.stamp.reset();
    file.opening.reset();
    file.awaits_rules = false;
    file.saved = document;
    update.requests.push_back(HoldFile{});
    replace_document(update, std::move(document));
}

void read_file(Update& update, const FileIntent& intent) {
    update.state.file.opening = intent;
    update.state.file.left = update.state.document;
    update.requests.push_back(ReadDocument{intent.path});
}

}  // namespace

void perform_intent(Update& update, const FileIntent& intent) {
    switch (intent.kind) {
        case Kind::create:
            return begin_unnamed(update, new_document());
        case Kind::close:
            return begin_unnamed(update, empty_document());
        case Kind::open:
        case Kind::sample:
        case Kind::revert:
            return read_file(update, intent);
        case Kind::recover:
            update.state.file.opening = intent;
            update.requests.push_back(ReadRecovery{intent.path});
            return;
        case Kind::quit:
            if (update.state.file.exporting) {
                update.state.file.after_saving = intent;
                tell(update, MessageKind::note, "Leaves when " + update.state.file.exporting->path + " is written");
                return;
            }
            update.requests.push_back(RemoveRecovery{});
            if (current_preferences(update.state) != update.state.recovery.written)
                update.requests.push_back(WritePreferences{current_preferences(update.state)});
            update.requests.push_back(CloseWindow{});
    }
}

void show_view(EditorState& state, const ViewTransform& view) {
    const Point size = state.canvas.view.size;
    state.canvas.view = view;
    state.canvas.view.size = size;
    state.canvas.fit_pending = false;
}

void note_recent(FileState& file, const std::string& path) {
    constexpr std::size_t most_recent = 12;
    std::erase(file.recent, path);
    file.recent.insert(file.recent.begin(), path);
    if (file.recent.size() > most_recent) file.recent.resize(most_recent);
    file.last_folder = std::filesystem::path(path).parent_path().string();
}

namespace {

void perform_one(Update& update, const NewDocument&) { ask_or_perform(update, {Kind::create, {}}); }
/// What grows, or what it grows on, stands beside the document.
void perform_one(Update& update, const OpenFile& action) {
    const FileKind kind = kind_of_name(action.path);
    if (kind == FileKind::mesh) return perform(update, SurfaceAction{OpenMesh{action.path}});
    if (kind == FileKind::shape_grammar) return perform(update, SurfaceAction{OpenShapeGrammar{action.path}});
    ask_or_perform(update, {Kind::open, action.path});
}
void perform_one(Update& update, const OpenSample& action) { ask_or_perform(update, {Kind::sample, action.path}); }
void perform_one(Update& update, const CloseFile&) { ask_or_perform(update, {Kind::close, {}}); }
void perform_one(Update& update, const QuitEditor&) { ask_or_perform(update, {Kind::quit, {}}); }

void perform_one(Update& update, const RevertFile&) {
    if (!update.state.file.path.empty()) ask_or_perform(update, {Kind::revert, update.state.file.path});
}

/// Was anything done since it was agreed that the document goes?
bool was_edited_since(const EditorState& state) {
    return !same_version(state.document, state.file.left) && has_unsaved_changes(state);
}

void perform_one(Update& update, const FileOpened& action) {
    FileState& file = update.state.file;
    if (!file.opening || file.opening->path != action.path) return;  // something else was opened since
    const FileIntent intent = *file.opening;
    file.opening.reset();
    if (was_edited_since(update.state)) return ask_or_perform(update, intent);
    const bool own = intent.kind != Kind::sample;
    const std::string& absolute = action.absolute.empty() ? action.path : action.absolute;
    file.path = own ? absolute : std::string();
    file.stamp = own ? action.stamp : std::nullopt;
    file.saved = action.document;
    file.left = {};
    file.awaits_rules = action.analyse;
    if (own) note_recent(file, absolute);
    update.requests.push_back(HoldFile{file.path});
    replace_document(update, action.document);
    if (action.view) show_view(update.state, *action.view);
    for (const std::string& warning : action.warnings) tell(update, MessageKind::warning, warning);
    if (action.analyse) perform(update, AnalysisAction{StartAnalysis{action.document.analysis}});
}

void perform_one(Update& update, const FileFailed& action) {
    FileState& file = update.state.file;
    if (file.opening && file.opening->path == action.path) {
        file.opening.reset();
        file.left = {};
    }
    std::erase(file.recent, action.path);
    tell(update, MessageKind::mistake, action.message);
}

void answer_unsaved(Update& update, const FileIntent& intent, FileAnswer answer) {
    if (answer == FileAnswer::discard) return perform_intent(update, intent);
    if (answer != FileAnswer::save) return;
    update.state.file.after_saving = intent;
    perform(update, FileAction{SaveFile{}});
}

void answer_one(Update& update, const UnsavedQuestion& question, FileAnswer answer) {
    answer_unsaved(update, question.then, answer);
}

void answer_one(Update& update, const ReplaceQuestion& question, FileAnswer answer) {
    if (answer != FileAnswer::replace) return;
    std::visit(
        [&](auto again) {
            again.replace = true;
            perform(update, FileAction{again});
        },
        question.again);
}

void answer_one(Update& update, const ChangedQuestion&, FileAnswer answer) {
    if (answer == FileAnswer::replace) {
        perform(update, FileAction{SaveFile{.even_if_changed = true}});
    } else if (answer == FileAnswer::save_as) {
        perform(update, DialogAction{ShowFileDialog{FilePurpose::save}});
    } else {
        update.state.file.after_saving.reset();
    }
}

void perform_one(Update& update, const AnswerFileQuestion& action) {
    if (!update.state.file.question) return;
    const FileQuestion question = std::move(*update.state.file.question);
    update.state.file.question.reset();
    std::visit([&](const auto& known) { answer_one(update, known, action.answer); }, question);
}

void perform_one(Update& update, const FileHeldElsewhere& action) {
    tell(update, MessageKind::warning,
         action.path +
             " is open in another window, too: if both save, the second is asked what to do. File > Save as keeps both");
}

template <class Saving>
void perform_one(Update& update, const Saving& action) {
    perform_saving(update, action);
}

}  // namespace

void perform(Update& update, const FileAction& action) {
    std::visit([&](const auto& one) { perform_one(update, one); }, action);
}

}  // namespace rinceau
