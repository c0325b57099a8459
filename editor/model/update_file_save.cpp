// Files: saving and exporting.

#include <filesystem>
#include <utility>

#include "editor/model/file_kind.h"
#include "editor/model/update_file_parts.h"

namespace rinceau {
namespace {

void write(Update& update, const std::string& path, bool replace, std::optional<FileStamp> expected) {
    EditorState& state = update.state;
    state.file.saving = true;
    update.requests.push_back(WriteDocument{path, state.document, state.canvas.view, replace, expected});
}

void close_dialog(EditorState& state, FilePurpose purpose) {
    if (state.dialog.file && state.dialog.file->purpose == purpose) state.dialog.file.reset();
}

/// Told in the dialog that asked for it, so that another name can be given, and in the log.
void tell_failure(Update& update, FilePurpose purpose, const std::string& message) {
    std::optional<FileDialog>& dialog = update.state.dialog.file;
    if (dialog && dialog->purpose == purpose) dialog->mistake = message;
    tell(update, MessageKind::mistake, message);
}

void continue_after(Update& update) {
    if (const auto intent = std::exchange(update.state.file.after_saving, {})) ask_or_perform(update, *intent);
}

}  // namespace

void perform_saving(Update& update, const SaveFile& action) {
    FileState& file = update.state.file;
    if (file.saving) return;
    if (file.path.empty() || !can_be_saved_as(kind_of_name(file.path))) {
        perform(update, DialogAction{ShowFileDialog{FilePurpose::save}});
        return;
    }
    write(update, file.path, true, action.even_if_changed ? std::nullopt : file.stamp);
}

void perform_saving(Update& update, const SaveFileAs& action) {
    if (update.state.file.saving) return;
    if (!can_be_saved_as(kind_of_name(action.path))) {
        tell_failure(update, FilePurpose::save,
                     action.path +
                         ": a document is saved as .rinceau (all), .lsys or .json (its grammar); for other "
                         "files use File > Export");
        return;
    }
    if (action.path == update.state.file.path && !action.replace) {
        perform_saving(update, SaveFile{});
    } else {
        write(update, action.path, action.replace, {});
    }
}

void perform_saving(Update& update, const FileSaved& action) {
    EditorState& state = update.state;
    state.file.saving = false;
    state.file.path = action.path;
    state.file.saved = action.document;
    state.file.stamp = action.stamp;
    note_recent(state.file, action.path);
    close_dialog(state, FilePurpose::save);
    update.requests.push_back(HoldFile{action.path});
    for (const std::string& warning : action.warnings) tell(update, MessageKind::warning, warning);
    tell(update, MessageKind::note, action.path + " is saved");
    continue_after(update);
}

void perform_saving(Update& update, const SaveFailed& action) {
    update.state.file.saving = false;
    update.state.file.after_saving.reset();
    tell_failure(update, FilePurpose::save, action.message);
}

void perform_saving(Update& update, const FileChangedOutside& action) {
    update.state.file.saving = false;
    update.state.file.question = ChangedQuestion{action.path};
}

void perform_saving(Update& update, const WouldReplace& action) {
    if (std::holds_alternative<SaveFileAs>(action.again)) {
        update.state.file.saving = false;
    } else {
        update.state.file.exporting.reset();
    }
    update.state.file.question = ReplaceQuestion{action.names, action.again};
}

void perform_saving(Update& update, const ExportFile& action) {
    EditorState& state = update.state;
    if (state.file.exporting) {
        tell_failure(update, FilePurpose::export_picture,
                     state.file.exporting->path + " is still being written: wait for it, or stop it");
        return;
    }
    state.file.exporting = RunningExport{action.path, "begin", 0};
    update.requests.push_back(WriteExport{action, state.document});
}

void perform_saving(Update& update, const ExportProgress& action) {
    if (!update.state.file.exporting) return;
    update.state.file.exporting->stage = action.stage;
    update.state.file.exporting->fraction = action.fraction;
}

void perform_saving(Update& update, const FileExported& action) {
    EditorState& state = update.state;
    state.file.exporting.reset();
    state.file.last_folder = std::filesystem::path(action.path).parent_path().string();
    close_dialog(state, FilePurpose::export_picture);
    tell(update, MessageKind::note, action.path + " is written");
    for (const std::string& note : action.notes) tell(update, MessageKind::warning, note);
    continue_after(update);
}

void perform_saving(Update& update, const ExportFailed& action) {
    update.state.file.exporting.reset();
    update.state.file.after_saving.reset();
    if (action.message.empty()) {
        tell(update, MessageKind::note, "The export was stopped; nothing was written");
    } else {
        tell_failure(update, FilePurpose::export_picture, action.message);
    }
}

void perform_saving(Update& update, const CancelExport&) {
    if (update.state.file.exporting) update.requests.push_back(StopExport{});
}

}  // namespace rinceau
