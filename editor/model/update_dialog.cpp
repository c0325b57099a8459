// The dialog for choosing a file.

#include <utility>

#include "editor/model/export_target.h"
#include "editor/model/update_dialog_parts.h"

namespace rinceau {
namespace {

/// The name that is proposed for a file beside the document's.
std::string proposed_name(const EditorState& state, FilePurpose purpose) {
    const std::string& path = state.file.path;
    if (purpose == FilePurpose::export_picture) return stem_of(path) + find_export_target(state.dialog.export_format).ending;
    if (purpose == FilePurpose::save && can_be_saved_as(kind_of_name(path))) return file_name_of(path);
    return stem_of(path) + ending_of(state.document.drawing ? FileKind::project : FileKind::grammar);
}

void list_folder(Update& update, FileDialog& dialog, std::string folder) {
    dialog.listing = true;
    update.requests.push_back(ListFolder{std::move(folder), dialog.folder});
}

void change_dialog(Update& update, const std::function<FileDialog(FileDialog)>& change) {
    std::optional<FileDialog>& dialog = update.state.dialog.file;
    if (dialog) dialog = change(std::move(*dialog));
}

void perform_one(Update& update, const ShowFileDialog& action) {
    EditorState& state = update.state;
    FileDialog dialog{.purpose = action.purpose};
    if (action.purpose == FilePurpose::export_picture) {
        dialog.format = state.dialog.export_format;
        dialog.choices = state.dialog.export_choices;
    }
    if (action.purpose != FilePurpose::open) dialog = with_text(std::move(dialog), proposed_name(state, action.purpose));
    list_folder(update, dialog, state.file.last_folder.empty() ? "." : state.file.last_folder);
    state.dialog.file = std::move(dialog);
    state.dialog.list.reset();
}

void perform_one(Update& update, const CloseFileDialog&) {
    update.state.dialog.file.reset();
    update.state.file.after_saving.reset();
}

void perform_one(Update& update, const FocusFileDialog&) {
    if (update.state.dialog.file) update.state.dialog.file->wants_focus = false;
}

void perform_one(Update& update, const TypeInFileDialog& action) {
    change_dialog(update, [&](FileDialog dialog) { return with_text(std::move(dialog), action.text); });
}

void perform_one(Update& update, const MoveInFileDialog& action) {
    change_dialog(update, [&](FileDialog dialog) { return with_row_moved(std::move(dialog), action.rows); });
}

void perform_one(Update& update, const SelectFileRow& action) {
    change_dialog(update, [&](FileDialog dialog) { return with_row(std::move(dialog), action.row); });
}

void perform_one(Update& update, const AcceptFileDialog&) {
    if (!update.state.dialog.file) return;
    FileDialog& dialog = *update.state.dialog.file;
    dialog.wants_focus = true;
    const std::string path = chosen_path(dialog);
    if (path.empty()) {
        dialog.mistake = dialog.purpose == FilePurpose::open ? "Choose a file" : "Type a name";
        return;
    }
    update.requests.push_back(LookAtPath{path, dialog.folder});
}

void perform_one(Update& update, const GoToFolder& action) {
    if (!update.state.dialog.file) return;
    update.state.dialog.file->wants_focus = true;
    list_folder(update, *update.state.dialog.file, action.folder);
}

void perform_one(Update& update, const ShowHiddenFiles& action) {
    change_dialog(update, [&](FileDialog dialog) {
        dialog.hidden = action.shown;
        return dialog;
    });
}

void perform_one(Update& update, const ShowAllKinds& action) {
    change_dialog(update, [&](FileDialog dialog) {
        dialog.all_kinds = action.shown;
        return dialog;
    });
}

void perform_one(Update& update, const NameNewFolder& action) {
    change_dialog(update, [&](FileDialog dialog) {
        dialog.new_folder = action.name;
        dialog.mistake.clear();
        return dialog;
    });
}

void perform_one(Update& update, const CancelNewFolder&) {
    change_dialog(update, [&](FileDialog dialog) {
        dialog.new_folder.reset();
        dialog.wants_focus = true;
        return dialog;
    });
}

void perform_one(Update& update, const MakeNewFolder&) {
    if (!update.state.dialog.file || !update.state.dialog.file->new_folder) return;
    FileDialog& dialog = *update.state.dialog.file;
    if (dialog.new_folder->empty()) {
        dialog.mistake = "Type the name of the new folder";
        return;
    }
    dialog.listing = true;
    update.requests.push_back(MakeFolder{*dialog.new_folder, dialog.folder});
}

void perform_one(Update& update, const ChooseFileKind& action) {
    change_dialog(update, [&](FileDialog dialog) { return with_file_kind(std::move(dialog), action.kind); });
}

void perform_one(Update& update, const ChooseExportFormat& action) {
    change_dialog(update, [&](FileDialog dialog) { return with_export_format(std::move(dialog), action.format); });
}

void perform_one(Update& update, const SetExportChoices& action) {
    change_dialog(update, [&](FileDialog dialog) {
        dialog.choices = action.choices;
        return dialog;
    });
}

void perform_one(Update& update, const FolderListed& action) {
    change_dialog(update, [&](FileDialog dialog) {
        const bool moved = !dialog.folder.empty();
        dialog.new_folder.reset();
        dialog = with_entries(std::move(dialog), action.folder, action.entries, action.cut_short);
        if (moved && (dialog.purpose == FilePurpose::open || is_path_text(dialog.text)))
            dialog.text = file_name_of(dialog.purpose == FilePurpose::open ? std::string() : dialog.text);
        return dialog;
    });
}

void perform_one(Update& update, const FolderFailed& action) {
    change_dialog(update, [&](FileDialog dialog) {
        dialog.listing = false;
        dialog.mistake = action.message;
        return dialog;
    });
}

/// What the dialog was for.
void accept_file(Update& update, const std::string& path, bool exists) {
    EditorState& state = update.state;
    FileDialog& dialog = *state.dialog.file;
    switch (dialog.purpose) {
        case FilePurpose::open:
            if (!exists) {
                dialog.mistake = "There is no file " + path;
                return;
            }
            state.dialog.file.reset();
            perform(update, FileAction{OpenFile{path}});
            return;
        case FilePurpose::save:
            perform(update, FileAction{SaveFileAs{path}});
            return;
        case FilePurpose::export_picture:
            state.dialog.export_format = dialog.format;
            state.dialog.export_choices = dialog.choices;
            perform(update, FileAction{ExportFile{path, dialog.format, dialog.choices}});
            return;
    }
}

void perform_one(Update& update, const PathSeen& action) {
    if (!update.state.dialog.file) return;
    if (action.what == PathSeen::What::folder) {
        list_folder(update, *update.state.dialog.file, action.path);
    } else {
        accept_file(update, action.path, action.what == PathSeen::What::file);
    }
}

template <class Pick>
void perform_one(Update& update, const Pick& action) {
    perform_pick(update, action);
}

}  // namespace

void perform(Update& update, const DialogAction& action) {
    std::visit([&](const auto& one) { perform_one(update, one); }, action);
}

}  // namespace rinceau
