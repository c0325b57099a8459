#pragma once
// A dialog for choosing a file: what it shows, and how keys and the mouse change that. Pure.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "editor/model/file_actions.h"
#include "editor/model/file_kind.h"

namespace rinceau {

enum class FilePurpose : unsigned char { open, save, export_picture };

/// "open", "save", "export": how the purpose is called in names of widgets.
std::string purpose_name(FilePurpose purpose);

struct FolderEntry {
    std::string name;
    bool folder = false;
    std::uint64_t bytes = 0;
    std::int64_t modified = 0;  ///< seconds since 1970
};

struct FileDialog {
    FilePurpose purpose = FilePurpose::open;
    std::string folder;                ///< absolute; empty = not known yet
    std::vector<FolderEntry> entries;  ///< of the folder: folders first, then by name
    bool listing = false;              ///< the entries of another folder are on their way
    bool cut_short = false;            ///< the folder holds more
    std::string text;                  ///< a name, a path, or what names must hold to be shown
    int selected = -1;                 ///< row of shown_entries(); -1 = none
    bool hidden = false;               ///< show names that begin with a dot
    bool all_kinds = false;            ///< show files that the purpose has no use for
    std::string mistake;
    std::optional<std::string> new_folder;  ///< its name while it is typed
    bool wants_focus = true;                ///< the text is to be typed into
    FileKind kind = FileKind::project;      ///< save: what is written
    std::string format;                     ///< export: name of export_target.h
    ExportChoices choices;                  ///< export
};

/// The entries that are shown, as indices.
std::vector<std::size_t> shown_entries(const FileDialog& dialog);

/// The entry of the selected row; nullptr without one.
const FolderEntry* selected_entry(const FileDialog& dialog);

FileDialog with_text(FileDialog dialog, std::string text);
FileDialog with_row_moved(FileDialog dialog, int rows);
FileDialog with_row(FileDialog dialog, int row);
FileDialog with_entries(FileDialog dialog, std::string folder, std::vector<FolderEntry> entries, bool cut_short);
/// The ending of the name follows.
FileDialog with_file_kind(FileDialog dialog, FileKind kind);
FileDialog with_export_format(FileDialog dialog, const std::string& format);

/// Does the text name a place rather than a part of a name: has it a slash or a tilde?
bool is_path_text(const std::string& text);

/// What is meant when the dialog is accepted: a path that is absolute, relative to the folder, or begins with ~. Empty if
/// nothing is chosen.
std::string chosen_path(const FileDialog& dialog);

}  // namespace rinceau
