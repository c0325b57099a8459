#pragma once
// The dialog for choosing a file.

#include <string>
#include <variant>
#include <vector>

#include "editor/model/file_dialog.h"
#include "editor/model/pick_list.h"

namespace rinceau {

struct ShowFileDialog {
    FilePurpose purpose = FilePurpose::open;
};
struct CloseFileDialog {};
/// The text field had the focus that it wanted.
struct FocusFileDialog {};
struct TypeInFileDialog {
    std::string text;
};
/// The arrow keys: so many rows down.
struct MoveInFileDialog {
    int rows = 0;
};
struct SelectFileRow {
    int row = 0;
};
/// Enter, OK or a double click: the folder that is chosen is gone into, the file opened or written.
struct AcceptFileDialog {};
/// Absolute, or relative to the dialog's folder: ".." is the folder above.
struct GoToFolder {
    std::string folder;
};
struct ShowHiddenFiles {
    bool shown = false;
};
struct ShowAllKinds {
    bool shown = false;
};
/// A name is typed for a new folder; accepted, it is made and gone into.
struct NameNewFolder {
    std::string name;
};
struct CancelNewFolder {};
struct MakeNewFolder {};
struct ChooseFileKind {
    FileKind kind = FileKind::project;
};
struct ChooseExportFormat {
    std::string format;
};
struct SetExportChoices {
    ExportChoices choices;
};

/// What a folder holds; or why that cannot be said.
struct FolderListed {
    std::string folder;  ///< absolute
    std::vector<FolderEntry> entries;
    bool cut_short = false;
};
struct FolderFailed {
    std::string message;
};
/// What stands at the path that was chosen.
struct PathSeen {
    enum class What : unsigned char { nothing, file, folder };
    std::string path;  ///< absolute
    What what = What::nothing;
};

/// The list of samples or of recent files.
struct ShowPickList {
    PickList::Of of = PickList::Of::samples;
};
struct ClosePickList {};
struct SamplesListed {
    std::vector<PickItem> samples;
};
struct MoveInPickList {
    int rows = 0;
};
/// The document of this row is opened; of the selected row, if it is below 0.
struct PickItemAt {
    int row = -1;
};

struct DialogAction
    : std::variant<ShowFileDialog, CloseFileDialog, FocusFileDialog, TypeInFileDialog, MoveInFileDialog, SelectFileRow,
                   AcceptFileDialog, GoToFolder, ShowHiddenFiles, ShowAllKinds, NameNewFolder, CancelNewFolder,
                   MakeNewFolder, ChooseFileKind, ChooseExportFormat, SetExportChoices, ShowPickList, ClosePickList,
                   SamplesListed, MoveInPickList, PickItemAt, FolderListed, FolderFailed, PathSeen> {
    using variant::variant;
    DialogAction(const DialogAction&);
    DialogAction(DialogAction&&) noexcept;
    DialogAction& operator=(const DialogAction&);
    DialogAction& operator=(DialogAction&&) noexcept;
    ~DialogAction();
};

}  // namespace rinceau
